using Foxglove;
using Google.Protobuf;
using Google.Protobuf.WellKnownTypes;
using Harvester.Datasets.Colours;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using KeyValuePair = Foxglove.KeyValuePair;
using Shape = Foxglove.PointsAnnotation.Types.Type;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// The messages of a frame. Frames of reference: world (x east, y north, z up), ego and LiDARs (x forward, y left, z up) and cameras (x
/// right, y down, z forward), metres.
/// </summary>
/// <param name="label">The label.</param>
/// <param name="nanoseconds">The moment, nanoseconds.</param>
/// <param name="camera">Name of the frame of reference of the camera.</param>
/// <param name="isFirst">Whether it is the first view of the moment.</param>
internal sealed class FoxgloveMessages(FrameLabel label, long nanoseconds, string camera, bool isFirst)
{
    /// <summary>Name of the frame of reference of the car.</summary>
    public const string Ego = "ego";

    private const string World = "world";
    private const double LineThicknessPixels = 2;
    private const double PointThicknessPixels = 4;
    private const double FontPixels = 12;
    private const double LaneThicknessMetres = 0.12;
    private const double CuboidOpacity = 0.35;

    private const int LaneColour = 0xFFFFFF;
    private const int JointColour = 0xFFE633;

    private readonly Timestamp _time = MessageTime.Of(nanoseconds);

    /// <summary>CompressedImage.</summary>
    /// <param name="bytes">A PNG or JPEG file.</param>
    /// <param name="format">png or jpeg.</param>
    public byte[] Image(byte[] bytes, string format) =>
        new CompressedImage
        {
            Timestamp = _time,
            FrameId = camera,
            Data = UnsafeByteOperations.UnsafeWrap(bytes),
            Format = format,
        }.ToByteArray();

    /// <summary>CameraCalibration; k1 and k2 are the first two of plumb_bob's five coefficients.</summary>
    public byte[] Calibration()
    {
        CameraLabel view = label.Camera;
        return new CameraCalibration
        {
            Timestamp = _time,
            FrameId = camera,
            Width = checked((uint)view.Width),
            Height = checked((uint)view.Height),
            DistortionModel = "plumb_bob",
            D = { view.Distortion.K1, view.Distortion.K2, 0, 0, 0 },
            K = { view.Fx, 0, view.Cx, 0, view.Fy, view.Cy, 0, 0, 1 },
            R = { 1, 0, 0, 0, 1, 0, 0, 0, 1 },
            P = { view.Fx, 0, view.Cx, 0, 0, view.Fy, view.Cy, 0, 0, 0, 1, 0 },
        }.ToByteArray();
    }

    /// <summary>FrameTransforms: the camera, and with the first view the ego and the LiDARs, in the world.</summary>
    /// <param name="lidars">Names of the frames of the LiDARs, and their poses.</param>
    public byte[] Transforms(IEnumerable<(string Frame, Geometry.Pose Pose)> lidars)
    {
        Axes ego = label.Ego.Axes ?? Axes.FromHeading(label.Ego.HeadingDegrees);
        FrameTransform own = Transform(camera, label.Camera.Pose.Position, Rotation.OfCamera(label.Camera.Pose.Axes));
        return new FrameTransforms
        {
            Transforms =
            {
                isFirst ? [Transform(Ego, label.Ego.Position, Rotation.OfBody(ego)), own] : [own],
                lidars.Select(lidar => Transform(lidar.Frame, lidar.Pose.Position, Rotation.OfBody(lidar.Pose.Axes))),
            },
        }.ToByteArray();
    }

    /// <summary>
    /// SceneUpdate: a cuboid for each object. The first view's stand in place of those of the moment before; other views add theirs, and
    /// an object that two of them see has one id and so one cuboid.
    /// </summary>
    public byte[] Objects(IReadOnlyList<ExportObject> objects) => Scene(objects.Select(Entity));

    /// <summary>SceneUpdate: a line for each lane line in the image.</summary>
    public byte[] Lanes(LanesLabel lanes) => Scene(lanes.Lines.Select(Entity));

    /// <summary>ImageAnnotations: boxes with captions, joints and lane lines, pixels.</summary>
    public byte[] Annotations(IReadOnlyList<ExportObject> objects) =>
        new ImageAnnotations
        {
            Timestamp = _time,
            Points =
            {
                objects.Select(item =>
                    Drawing(Shape.LineLoop, Corners(item.Box), ClassColours.Of(item.Label.Class), LineThicknessPixels, Facts(item))
                ),
                objects
                    .Where(item => item.Label.Joints is not null)
                    .Select(item => Drawing(Shape.Points, JointsOf(item), JointColour, PointThicknessPixels, Facts(item))),
                (label.Lanes?.Lines ?? []).Select(line =>
                    Drawing(Shape.LineStrip, line.Points.Select(point => point.Pixel), LaneColour, LineThicknessPixels, Facts(line))
                ),
            },
            Texts = { objects.Select(Caption) },
        }.ToByteArray();

    private byte[] Scene(IEnumerable<SceneEntity> entities) =>
        new SceneUpdate
        {
            Deletions =
            {
                isFirst
                    ? [new SceneEntityDeletion { Timestamp = _time, Type = SceneEntityDeletion.Types.Type.All }]
                    : Array.Empty<SceneEntityDeletion>(),
            },
            Entities = { entities },
        }.ToByteArray();

    private SceneEntity Entity(ExportObject item)
    {
        Vector3D half = item.Label.Box3D.HalfExtents;
        return new SceneEntity
        {
            Timestamp = _time,
            FrameId = World,
            Id = $"{item.Label.Id}",
            Metadata = { Facts(item) },
            Cubes =
            {
                new CubePrimitive
                {
                    Pose = Pose(item.Label.Box3D.Centre, Rotation.OfBody(item.Label.Box3D.Axes)),
                    Size = Vector(new Vector3D(2 * half.Y, 2 * half.X, 2 * half.Z)),
                    Color = Paint(ClassColours.Of(item.Label.Class), CuboidOpacity),
                },
            },
        };
    }

    private SceneEntity Entity(LaneLineView line, int index) =>
        new()
        {
            Timestamp = _time,
            FrameId = World,
            Id = label.View is { } view ? $"{view}/{index}" : $"{index}",
            Metadata = { Facts(line) },
            Lines =
            {
                new LinePrimitive
                {
                    Pose = Pose(Vector3D.Zero, Rotation.None),
                    Thickness = LaneThicknessMetres,
                    Points = { line.Points.Select(at => Point(at.World)) },
                    Color = Paint(LaneColour),
                },
            },
        };

    private FrameTransform Transform(string child, Vector3D position, Rotation rotation) =>
        new()
        {
            Timestamp = _time,
            ParentFrameId = World,
            ChildFrameId = child,
            Translation = Vector(position),
            Rotation = Quaternion(rotation),
        };

    private PointsAnnotation Drawing(
        Shape shape,
        IEnumerable<Vector2D> points,
        int colour,
        double thickness,
        IEnumerable<KeyValuePair> facts
    ) =>
        new()
        {
            Timestamp = _time,
            Type = shape,
            Points = { points.Select(Point) },
            OutlineColor = Paint(colour),
            Thickness = thickness,
            Metadata = { facts },
        };

    private TextAnnotation Caption(ExportObject item) =>
        new()
        {
            Timestamp = _time,
            Position = Point(new Vector2D(item.Box.XMin, item.Box.YMin)),
            Text = item.Class.Name,
            FontSize = FontPixels,
            TextColor = Paint(ClassColours.Of(item.Label.Class)),
        };

    private static IEnumerable<Vector2D> JointsOf(ExportObject item) =>
        item.Label.Joints!.Joints.Where(joint => joint.Pixel is not null).Select(joint => joint.Pixel!.Value);

    private static IEnumerable<KeyValuePair> Facts(ExportObject item)
    {
        ObjectLabel label = item.Label;
        yield return Fact("id", $"{label.Id}");
        yield return Fact("class", item.Class.Name);
        yield return Fact("model", label.Model);
        if (label.Name is { } name)
        {
            yield return Fact("name", name);
        }

        yield return Fact("truncatedFraction", FormattableString.Invariant($"{label.TruncatedFraction:0.###}"));
        if (label.OccludedFraction is { } occluded)
        {
            yield return Fact("occludedFraction", FormattableString.Invariant($"{occluded:0.###}"));
        }
    }

    private static IEnumerable<KeyValuePair> Facts(LaneLineView line) =>
        [
            Fact("index", FormattableString.Invariant($"{line.Index}")),
            .. line.Paint is { } paint
                ? [Fact("style", paint.Style.ToString()), Fact("colour", paint.Colour.ToString())]
                : Array.Empty<KeyValuePair>(),
        ];

    private static Vector2D[] Corners(Box2D box) =>
        [new(box.XMin, box.YMin), new(box.XMax, box.YMin), new(box.XMax, box.YMax), new(box.XMin, box.YMax)];

    private static KeyValuePair Fact(string key, string value) => new() { Key = key, Value = value };

    private static Point2 Point(Vector2D point) => new() { X = point.X, Y = point.Y };

    private static Point3 Point(Vector3D point) =>
        new()
        {
            X = point.X,
            Y = point.Y,
            Z = point.Z,
        };

    private static Foxglove.Vector3 Vector(Vector3D vector) =>
        new()
        {
            X = vector.X,
            Y = vector.Y,
            Z = vector.Z,
        };

    private static Foxglove.Quaternion Quaternion(Rotation rotation) =>
        new()
        {
            X = rotation.X,
            Y = rotation.Y,
            Z = rotation.Z,
            W = rotation.W,
        };

    private static Foxglove.Pose Pose(Vector3D position, Rotation rotation) =>
        new() { Position = Vector(position), Orientation = Quaternion(rotation) };

    /// <summary>A colour.</summary>
    /// <param name="colour">0xRRGGBB.</param>
    /// <param name="opacity">0 to 1.</param>
    private static Color Paint(int colour, double opacity = 1) =>
        new()
        {
            R = ((colour >> 16) & 0xFF) / 255.0,
            G = ((colour >> 8) & 0xFF) / 255.0,
            B = (colour & 0xFF) / 255.0,
            A = opacity,
        };
}
