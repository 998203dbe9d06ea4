// Marks what the shared library shows; everything else stays inside.
#pragma once

#include <glint/export.h>
