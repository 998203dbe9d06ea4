// What goes wrong in the native library.
package glint.android

/**
 * A scene that cannot be read, a picture that cannot be rendered or shown. The message is for a person: of a scene file
 * it names every problem with file, line, column and what was expected.
 */
public class GlintException internal constructor(
    /** What a program decides by. */
    public val code: Code,
    message: String,
) : RuntimeException(message) {
    /** Called by the native library. */
    internal constructor(code: Int, message: String) : this(Code.entries.getOrElse(code) { Code.UNSUPPORTED }, message)

    /** Kinds of failures, in the native library's order. */
    public enum class Code {
        /** A file's contents, or what the caller asked for, are not valid. */
        BAD_INPUT,

        /** A file is missing, or may not be read. */
        NOT_FOUND,

        /** Valid, but larger than a limit. */
        LIMIT_EXCEEDED,

        /** The system refused to read. */
        IO,

        /** This device, or this build, cannot do it. */
        UNSUPPORTED,

        /** Somebody asked to stop. */
        CANCELLED,

        /** The system gave no more memory; the call may be tried again. */
        OUT_OF_MEMORY,
    }
}
