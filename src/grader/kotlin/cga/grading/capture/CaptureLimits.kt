package cga.grading.capture

/** What a capture may hold at most: far above any game of the course, far below what hurts the reader. */
public object CaptureLimits {
    /** Bytes of the whole capture, decompressed. */
    public const val BYTES: Long = 512L shl 20

    /** Elements of all lists together: what a small file may become in memory. */
    public const val ELEMENTS: Int = 1 shl 21

    /** Pixels a side of the window, and texels a side of a texture. */
    public const val SIDE: Int = 8192
    public const val SAMPLES: Int = 16
    public const val PROGRAMS: Int = 4096
    public const val SOURCE: Int = 1 shl 20
    public const val BUFFERS: Int = 65_536
    public const val TEXTURES: Int = 8192
    public const val FRAMES: Int = 1024

    /** Steps of one frame, and of all frames. */
    public const val STEPS: Int = 16_384
    public const val ALL_STEPS: Int = 131_072
    public const val EVENTS: Int = 8192
    public const val EVENT_TEXT: Int = 2000
    public const val NAME: Int = 1024

    /** Chains of calls, the calls of one, and the characters of each. */
    public const val CALLERS: Int = 4096
    public const val CALLS: Int = 8
    public const val CALL: Int = 200

    /** Uniforms of one draw; OpenGL implementations have at most so many components. */
    public const val UNIFORMS: Int = 16_384
    public const val ATTRIBUTES: Int = 32
    public const val UNITS: Int = 256
    public const val INSTANCES: Int = 4096

    /** Indices of all draws together that the reader looks at to see where they point. */
    public const val INDICES: Long = 1L shl 29
}
