package cga.coach

/** Where `./cga run` begins in an exercise's folder. */
public object Coach {
    @JvmStatic
    public fun main(
        @Suppress("UNUSED_PARAMETER") arguments: Array<String>,
    ): Unit = Tools.host.runBuilt()
}
