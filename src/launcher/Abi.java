import java.io.DataInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.CRC32;

/**
 * What others compile against, as a number for each folder of classes: names, types and values of all that is not private, and Kotlin's
 * metadata. Bodies do not count, except those of inline functions, which are told by the sources. Java, since it starts in a tenth of a second.
 */
public final class Abi {
    private static final int PRIVATE_OR_SYNTHETIC = 0x0002 | 0x1000;

    public static void main(String[] folders) throws IOException {
        for (String folder : folders) {
            CRC32 sum = new CRC32();
            try (Stream<Path> files = Files.walk(Path.of(folder))) {
                List<Path> classes = files.filter(file -> file.toString().endsWith(".class")).sorted().toList();
                for (Path file : classes) sum.update(interfaceOf(Files.readAllBytes(file)).getBytes());
            }
            System.out.println(folder + " " + sum.getValue());
        }
    }

    /** Empty for a class inside of a function. The format is chapter 4 of the JVM specification. */
    private static String interfaceOf(byte[] bytes) throws IOException {
        DataInputStream in = new DataInputStream(new java.io.ByteArrayInputStream(bytes));
        in.skipNBytes(8);
        Object[] pool = pool(in);
        StringBuilder said = new StringBuilder().append(in.readUnsignedShort());
        said.append(name(pool, in.readUnsignedShort())).append(name(pool, in.readUnsignedShort()));
        for (int i = in.readUnsignedShort(); i > 0; i--) said.append(name(pool, in.readUnsignedShort()));
        for (int kind = 0; kind < 2; kind++) {
            for (int i = in.readUnsignedShort(); i > 0; i--) {
                int access = in.readUnsignedShort();
                String member = "\n" + access + " " + pool[in.readUnsignedShort()] + " " + pool[in.readUnsignedShort()] + attributes(in, pool, bytes);
                if ((access & PRIVATE_OR_SYNTHETIC) == 0) said.append(member);
            }
        }
        String attributes = attributes(in, pool, bytes);
        return attributes.contains("EnclosingMethod") ? "" : said.append(attributes).toString();
    }

    /** Those that say something to others: constants' values, exceptions, generic types, and annotations, of which Kotlin's metadata is one. */
    private static String attributes(DataInputStream in, Object[] pool, byte[] bytes) throws IOException {
        StringBuilder said = new StringBuilder();
        for (int i = in.readUnsignedShort(); i > 0; i--) {
            String name = (String) pool[in.readUnsignedShort()];
            byte[] content = new byte[in.readInt()];
            in.readFully(content);
            switch (name) {
                case "ConstantValue", "Signature" -> said.append(pool[(content[0] & 0xff) << 8 | content[1] & 0xff]);
                case "RuntimeVisibleAnnotations" -> annotations(said, content, pool);
                case "EnclosingMethod" -> said.append(name);
                default -> { }
            }
        }
        return said.toString();
    }

    /** All constants that the annotations name, in their order: the pool's own numbers change with any body. */
    private static void annotations(StringBuilder said, byte[] content, Object[] pool) throws IOException {
        DataInputStream in = new DataInputStream(new java.io.ByteArrayInputStream(content));
        for (int i = in.readUnsignedShort(); i > 0; i--) annotation(said, in, pool);
    }

    private static void annotation(StringBuilder said, DataInputStream in, Object[] pool) throws IOException {
        said.append(pool[in.readUnsignedShort()]);
        for (int i = in.readUnsignedShort(); i > 0; i--) {
            said.append(pool[in.readUnsignedShort()]);
            value(said, in, pool);
        }
    }

    private static void value(StringBuilder said, DataInputStream in, Object[] pool) throws IOException {
        char tag = (char) in.readUnsignedByte();
        switch (tag) {
            case '@' -> annotation(said, in, pool);
            case '[' -> {
                for (int i = in.readUnsignedShort(); i > 0; i--) value(said, in, pool);
            }
            case 'e' -> said.append(pool[in.readUnsignedShort()]).append(pool[in.readUnsignedShort()]);
            default -> said.append(pool[in.readUnsignedShort()]);
        }
    }

    /** Texts and numbers as they are, of a class or a string the index of its text. */
    private static Object[] pool(DataInputStream in) throws IOException {
        Object[] pool = new Object[in.readUnsignedShort()];
        for (int i = 1; i < pool.length; i++) {
            switch (in.readUnsignedByte()) {
                case 1 -> pool[i] = in.readUTF();
                case 3 -> pool[i] = in.readInt();
                case 4 -> pool[i] = in.readFloat();
                case 5 -> pool[i++] = in.readLong();
                case 6 -> pool[i++] = in.readDouble();
                case 7, 8, 16, 19, 20 -> pool[i] = in.readUnsignedShort();
                case 15 -> in.skipNBytes(3);
                default -> in.skipNBytes(4);
            }
        }
        return pool;
    }

    private static Object name(Object[] pool, int index) {
        return index == 0 ? "" : pool[(Integer) pool[index]];
    }
}
