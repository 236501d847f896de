package cga.coach.calls

import org.lwjgl.system.APIUtil.apiCreateCIF
import org.lwjgl.system.Callback
import org.lwjgl.system.CallbackI
import org.lwjgl.system.FunctionProvider
import org.lwjgl.system.MemoryUtil
import org.lwjgl.system.libffi.FFICIF
import java.lang.invoke.MethodHandles
import java.nio.ByteBuffer

/**
 * Hands OpenGL's functions to LWJGL with [observer] in between: whoever calls one of [Signatures] calls a function of ours, which may look,
 * change and pass on.
 *
 * A call that the observer makes itself goes straight to the driver. Observers must not need memory in calls that LWJGL makes with the
 * garbage collector locked out (those that take Java arrays); they may then take a few small objects, no more.
 *
 * @param isObserved tells by a function's name whether calls of it are looked at; the others go straight to the driver.
 */
public class Interception(
    private val driver: (ByteBuffer) -> Long,
    private val isObserved: (String) -> Boolean = { true },
    private val observer: (Call) -> Unit,
) : FunctionProvider {
    private val hooks = HashMap<String, Hook>()
    private val plans = HashMap<String, FFICIF>()
    private var observing = false

    override fun getFunctionAddress(functionName: ByteBuffer): Long {
        val address = driver(functionName)
        if (address == 0L) return 0
        val name = MemoryUtil.memASCII(functionName).trimEnd('\u0000')
        val signature = Signatures.byName[name]?.takeIf { isObserved(name) } ?: return address
        return hooks.getOrPut(name) { Hook(name, plan(signature), address) }.native
    }

    /** Runs [block] with the observer looking away. */
    public fun <T> aside(block: () -> T): T {
        val before = observing
        observing = true
        try {
            return block()
        } finally {
            observing = before
        }
    }

    private fun plan(signature: String) =
        plans.getOrPut(signature) {
            val arguments = signature.drop(1).map(Signatures::type)
            apiCreateCIF(Signatures.type(signature[0]), *arguments.toTypedArray())
        }

    private inner class Hook(
        private val name: String,
        private val plan: FFICIF,
        private val function: Long,
    ) : CallbackI {
        val native: Long = address()

        override fun getDescriptor() = Callback.Descriptor(CallbackI::class.java, MethodHandles.lookup(), plan)

        override fun callback(
            ret: Long,
            args: Long,
        ) {
            val call = Call(name, plan.address(), function, ret, args)
            if (observing) return call.proceed()
            observing = true
            try {
                observer(call)
            } finally {
                observing = false
            }
        }
    }
}
