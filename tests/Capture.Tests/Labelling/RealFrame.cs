using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>One frame of the real game, read through its graphics: the camera, the vehicles, and depth and kind of each pixel.</summary>
internal sealed class RealFrame
{
    public const string Folder = "frame-208/";

    public const string Scene = Folder + "scene.json";

    private const byte VehicleBits = 2;

    private readonly TestPngDecoder _depth = Png("depth.png");

    private readonly TestPngDecoder _stencil = Png("stencil.png");

    private RealFrame()
    {
        using JsonDocument scene = JsonDocument.Parse(File.ReadAllBytes(RealWorldFactAttribute.PathOf(Scene)!));
        JsonElement root = scene.RootElement;
        Vector3D angles = Vector(root.GetProperty("camera_rot"));
        var size = new ImageSize(root.GetProperty("width").GetInt32(), root.GetProperty("height").GetInt32());
        Camera = new Camera(
            new Pose(Vector(root.GetProperty("camera_pos")), Axes.FromEuler(new EulerAngles(angles.X, angles.Y, angles.Z))),
            new CameraIntrinsics(
                root.GetProperty("camera_fov").GetDouble(),
                size,
                (double)size.Width / size.Height,
                nearClip: 0.15,
                Lens.Ideal
            )
        );
        Vehicles =
        [
            .. root.GetProperty("entities")
                .EnumerateArray()
                .Where(entity => entity.GetProperty("type").GetString() == "car")
                .Select(entity => (entity.GetProperty("class").GetString()!, CuboidOf(entity))),
        ];
    }

    public Camera Camera { get; }

    /// <summary>The vehicles: the game's name of the class, and the cuboid of the model at the entity's pose.</summary>
    public IReadOnlyList<(string GameClass, Cuboid Cuboid)> Vehicles { get; }

    public static RealFrame Read() => new();

    /// <summary>The pixels that show a vehicle nearer than a depth along the view axis, with that depth, metres.</summary>
    public IEnumerable<(int X, int Y, double Depth)> VehiclePixels(double nearerThan)
    {
        for (int pixel = 0; pixel < _stencil.Samples.Length; pixel++)
        {
            if ((_stencil.Samples[pixel] & 7) != VehicleBits)
            {
                continue;
            }

            // As the frame's own description says: raw = 65535 · (0.15 / z + 1.5e-5), and 0 is the sky.
            int raw = (_depth.Samples[2 * pixel] << 8) | _depth.Samples[(2 * pixel) + 1];
            double depth = 0.15 * 65535 / (raw - 0.98);
            if (raw > 0 && depth < nearerThan)
            {
                yield return (pixel % _stencil.Width, pixel / _stencil.Width, depth);
            }
        }
    }

    private static Cuboid CuboidOf(JsonElement entity)
    {
        double[] sizes = [.. entity.GetProperty("model_sizes").EnumerateArray().Select(size => size.GetDouble())];
        return Cuboid.FromModel(
            new(sizes[0], sizes[2], sizes[4]),
            new(sizes[1], sizes[3], sizes[5]),
            new Pose(Vector(entity.GetProperty("pos")), AxesOf(Vector(entity.GetProperty("rot"))))
        );
    }

    /// <summary>The orientation of angles of the game's rotation order 0: the columns of Rz(yaw) · Ry(roll) · Rx(pitch).</summary>
    private static Axes AxesOf(Vector3D degrees)
    {
        (double sp, double cp) = Math.SinCos(degrees.X * Math.PI / 180);
        (double sr, double cr) = Math.SinCos(degrees.Y * Math.PI / 180);
        (double sy, double cy) = Math.SinCos(degrees.Z * Math.PI / 180);
        return Axes.FromVectors(
            new(cy * cr, sy * cr, -sr),
            new((cy * sr * sp) - (sy * cp), (sy * sr * sp) + (cy * cp), cr * sp),
            new((cy * sr * cp) + (sy * sp), (sy * sr * cp) - (cy * sp), cr * cp)
        );
    }

    private static Vector3D Vector(JsonElement numbers) => new(numbers[0].GetDouble(), numbers[1].GetDouble(), numbers[2].GetDouble());

    private static TestPngDecoder Png(string name) =>
        TestPngDecoder.Decode(File.ReadAllBytes(RealWorldFactAttribute.PathOf(Folder + name)!));
}
