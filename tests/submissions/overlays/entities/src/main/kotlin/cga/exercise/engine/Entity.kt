package cga.exercise.engine

import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.light.PointLight
import org.joml.Vector3f

interface Component

class Shape(val meshes: List<Mesh>) : Component
class Emission(val color: Vector3f) : Component
class Lamp(val light: PointLight) : Component
class Pulse(val speeds: Vector3f) : Component

/** A node of the scene: a place, and components that say what is there. */
class Entity(val name: String, val node: Transformable = Transformable()) {
    val children = ArrayList<Entity>()
    private val components = HashMap<Class<*>, Component>()

    fun add(component: Component) {
        components[component.javaClass] = component
    }

    fun <T : Component> get(type: Class<T>): T? = type.cast(components[type])

    inline fun <reified T : Component> find(): T? = get(T::class.java)

    fun attach(child: Entity) {
        children += child
        child.node.parent = node
    }

    /** This entity and all below it. */
    fun walk(visit: (Entity) -> Unit) {
        visit(this)
        children.forEach { it.walk(visit) }
    }
}
