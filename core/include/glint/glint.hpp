// All of Glint's C++ interface.
#pragma once

#include <glint/accel.hpp>
#include <glint/animation.hpp>
#include <glint/camera_control.hpp>
#include <glint/file_source.hpp>
#include <glint/framebuffer.hpp>
#include <glint/governor.hpp>
#include <glint/host_threads.hpp>
#include <glint/isa.hpp>
#include <glint/motion.hpp>
#include <glint/quadric.hpp>
#include <glint/ray_query.hpp>
#include <glint/ray_tree.hpp>
#include <glint/read.hpp>
#include <glint/refiner.hpp>
#include <glint/render_job.hpp>
#include <glint/renderer.hpp>
#include <glint/result.hpp>
#include <glint/rigid_transform.hpp>
#include <glint/scene.hpp>
#include <glint/version.hpp>
