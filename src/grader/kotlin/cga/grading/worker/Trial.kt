package cga.grading.worker

/** A submission of our own that opens a window as the course does and nothing else: whether there is OpenGL here. */
public object Trial {
    @JvmStatic
    public fun main(args: Array<String>) {
        Stage(SIZE, SIZE, "trial", MAJOR, MINOR, SAMPLES, FREQUENCY)
    }

    private const val SIZE = 64
    private const val MAJOR = 3
    private const val MINOR = 3
    private const val SAMPLES = 4
    private const val FREQUENCY = 120.0
}
