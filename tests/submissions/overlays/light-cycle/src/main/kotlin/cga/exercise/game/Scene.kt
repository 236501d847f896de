package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader.loadModel
import cga.framework.OBJLoader.loadOBJ
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*

/**
 * Created by Fabian on 16.09.2017.
 */
class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

    private val ground: Renderable
    private val bike: Renderable
    //private val sphere: Renderable

    private val groundMaterial: Material
    private val groundColor: Vector3f

    //Lights
    private val bikePointLight: PointLight
    private val bikeSpotLight: SpotLight
    private val pointLightList = mutableListOf<PointLight>()

    //camera
    private val camera: TronCamera
    private var oldMouseX = 0.0
    private var oldMouseY = 0.0
    private var firstMouseMove = true

    //scene setup
    init {
        //load textures
        val groundDiff = Texture2D("assets/textures/ground_diff.png", true)
        groundDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundSpecular = Texture2D("assets/textures/ground_spec.png", true)
        groundSpecular.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val groundEmit = Texture2D("assets/textures/ground_emit.png", true)
        groundEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        groundMaterial = Material(groundDiff, groundEmit, groundSpecular, 60.0f, Vector2f(64.0f, 64.0f))

        //load an object and create a mesh
        val gres = loadOBJ("assets/models/ground.obj")
        //Create the mesh
        val stride = 8 * 4
        val atr1 = VertexAttribute(3, stride, 0)     //position attribute
        val atr2 = VertexAttribute(2, stride, 3 * 4) //texture coordinate attribute
        val atr3 = VertexAttribute(3, stride, 5 * 4) //normal attribute
        val vertexAttributes = arrayOf(atr1, atr2, atr3)
        val groundMesh = Mesh(gres.vertexData, gres.indexData, vertexAttributes, groundMaterial)

        ground = Renderable()
        ground.meshes.add(groundMesh)

        bike = loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw IllegalArgumentException("Could not load the model")
        bike.scale(Vector3f(0.8f, 0.8f, 0.8f))

        //setup camera
        camera = TronCamera()
        camera.parent = bike
        camera.rotate(Math.toRadians(-35.0f), 0.0f, 0.0f)
        camera.translate(Vector3f(0.0f, 0.0f, 4.5f))

        groundColor = Vector3f(0.0f, 1.0f, 0.0f)

        //bike point light
        bikePointLight = PointLight("bikePoint", Vector3f(1.0f, 1.0f, 1.0f), Vector3f(0.0f, 1.6f, 0.5f))
        bikePointLight.parent = bike

        //bike spot light
        bikeSpotLight = SpotLight("bikeSpot", Vector3f(25.0f, 25.0f, 22.0f), Vector3f(0.0f, 1.0f, -1.5f), Math.toRadians(18.0f), Math.toRadians(30.0f))
        bikeSpotLight.rotate(Math.toRadians(-12.0f), 0.0f, 0.0f)
        bikeSpotLight.parent = bike

        // additional lights in the scene
        pointLightList.add(PointLight("redCorner", Vector3f(30.0f, 1.0f, 1.0f), Vector3f(-12.0f, 2.0f, -12.0f)))
        pointLightList.add(PointLight("blueCorner", Vector3f(1.0f, 2.0f, 35.0f), Vector3f(12.0f, 2.0f, -12.0f)))
        pointLightList.add(PointLight("yellowCorner", Vector3f(26.0f, 24.0f, 2.0f), Vector3f(12.0f, 2.0f, 12.0f)))
        pointLightList.add(PointLight("violetCorner", Vector3f(20.0f, 1.0f, 28.0f), Vector3f(-12.0f, 2.0f, 12.0f)))

        //initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        staticShader.use()
        camera.bind(staticShader)

        val changingColor = Vector3f(Math.abs(Math.sin(t)), Math.abs(Math.sin(t / 2.0f)), Math.abs(Math.cos(t)))
        bikePointLight.lightColor = changingColor

        // bind lights
        bikePointLight.bind(staticShader)
        bikeSpotLight.bind(staticShader, camera.getCalculateViewMatrix())
        for (pointLight in pointLightList) {
            pointLight.bind(staticShader)
        }

        // render objects
        staticShader.setUniform("shadingColor", groundColor)
        ground.render(staticShader)
        staticShader.setUniform("shadingColor", changingColor)
        bike.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        val moveMul = 8.0f
        val rotateMul = 0.5f * Math.PI.toFloat()
        if (window.getKeyState(GLFW_KEY_W)) {
            bike.translate(Vector3f(0.0f, 0.0f, -dt * moveMul))
            if (window.getKeyState(GLFW_KEY_A)) {
                bike.rotate(0.0f, dt * rotateMul, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                bike.rotate(0.0f, -dt * rotateMul, 0.0f)
            }
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            bike.translate(Vector3f(0.0f, 0.0f, dt * moveMul))
            if (window.getKeyState(GLFW_KEY_A)) {
                bike.rotate(0.0f, -dt * rotateMul, 0.0f)
            }
            if (window.getKeyState(GLFW_KEY_D)) {
                bike.rotate(0.0f, dt * rotateMul, 0.0f)
            }
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_P && action == GLFW_PRESS) println("bike: " + bike.getWorldPosition() + " camera: " + camera.getWorldPosition())
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (!firstMouseMove) {
            val yawAngle = (xpos - oldMouseX).toFloat() * 0.002f
            camera.rotateAroundPoint(0.0f, -yawAngle, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
        } else {
            firstMouseMove = false
        }
        oldMouseX = xpos
        oldMouseY = ypos
    }

    fun cleanup() {
        ground.cleanup()
        bike.cleanup()
        staticShader.cleanup()
    }
}
