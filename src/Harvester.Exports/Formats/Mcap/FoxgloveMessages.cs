using Harvester.Datasets.Colours;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// The messages of a moment. Frames of reference: world (x east, y north, z up), ego (x forward, y left, z up) and camera (x right, y down,
/// z forward), metres.
/// </summary>
/// <param name="label">The label.</param>
/// <param name="nanoseconds">The moment, nanoseconds.</param>
internal sealed class FoxgloveMessages(FrameLabel label, long nanoseconds)
{
    /// <summary>Name of the frame of reference of the car.</summary>
    public const string Ego = "ego";

    private const string World = "world";
    private const string CameraFrame = "camera";
    private const long NanosecondsPerSecond = 1_000_000_000;
    private const int ImageHeadBytes = 64;

    private const int DeleteAll = 1;
    private const int Points = 1;
    private const int LineLoop = 2;
    private const int LineStrip = 3;

    private const double LineThicknessPixels = 2;
    private const double PointThicknessPixels = 4;
    private const double FontPixels = 12;
    private const double LaneThicknessMetres = 0.12;
    private const double CuboidOpacity = 0.35;

    private const int LaneColour = 0xFFFFFF;
    private const int JointColour = 0xFFE633;

    public static void Time(ProtoMessage message, int field, long nanoseconds) =>
        message.Message(field, time => time.Integer(1, nanoseconds / NanosecondsPerSecond).Integer(2, nanoseconds % NanosecondsPerSecond));

    /// <summary>CompressedImage.</summary>
    /// <param name="bytes">A PNG or JPEG file.</param>
    /// <param name="format">png or jpeg.</param>
    public byte[] Image(byte[] bytes, string format) =>
        ProtoMessage.Of(
            message =>
            {
                Time(message, 1);
                message.Bytes(ImageMessage.DataField, bytes).Text(3, format).Text(4, CameraFrame);
            },
            bytes.Length + ImageHeadBytes
        );

    /// <summary>CameraCalibration; k1 and k2 are the first two of plumb_bob's five coefficients.</summary>
    public byte[] Calibration() =>
        ProtoMessage.Of(message =>
        {
            CameraLabel camera = label.Camera;
            Time(message, 1);
            message
                .Fixed32(2, camera.Width)
                .Fixed32(3, camera.Height)
                .Text(4, "plumb_bob")
                .Numbers(5, [camera.Distortion.K1, camera.Distortion.K2, 0, 0, 0])
                .Numbers(6, [camera.Fx, 0, camera.Cx, 0, camera.Fy, camera.Cy, 0, 0, 1])
                .Numbers(7, [1, 0, 0, 0, 1, 0, 0, 0, 1])
                .Numbers(8, [camera.Fx, 0, camera.Cx, 0, 0, camera.Fy, camera.Cy, 0, 0, 0, 1, 0])
                .Text(9, CameraFrame);
        });

    /// <summary>FrameTransforms: the ego and the camera in the world.</summary>
    public byte[] Transforms() =>
        ProtoMessage.Of(message =>
        {
            Axes ego = label.Ego.Axes ?? Axes.FromHeading(label.Ego.HeadingDegrees);
            Transform(Ego, label.Ego.Position, Rotation.OfBody(ego));
            Transform(CameraFrame, label.Camera.Pose.Position, Rotation.OfCamera(label.Camera.Pose.Axes));

            void Transform(string child, Vector3D position, Rotation rotation) =>
                message.Message(
                    1,
                    transform =>
                    {
                        Time(transform, 1);
                        transform
                            .Text(2, World)
                            .Text(3, child)
                            .Message(4, vector => Vector(vector, position))
                            .Message(5, quaternion => Quaternion(quaternion, rotation));
                    }
                );
        });

    /// <summary>SceneUpdate: a cuboid for each object, in place of those of the moment before.</summary>
    public byte[] Objects(IReadOnlyList<ExportObject> objects) =>
        Scene(update =>
            update.Messages(
                2,
                objects,
                (entity, item) =>
                {
                    Time(entity, 1);
                    entity
                        .Text(2, World)
                        .Text(3, $"{item.Label.Id}")
                        .Messages(6, Facts(item), (pair, fact) => Pair(pair, fact.Name, fact.Value));
                    entity.Message(
                        8,
                        cube =>
                        {
                            Vector3D half = item.Label.Box3D.HalfExtents;
                            cube.Message(1, pose => Pose(pose, item.Label.Box3D.Centre, Rotation.OfBody(item.Label.Box3D.Axes)))
                                .Message(2, size => Vector(size, new Vector3D(2 * half.Y, 2 * half.X, 2 * half.Z)))
                                .Message(3, colour => Paint(colour, ClassColours.Of(item.Label.Class), CuboidOpacity));
                        }
                    );
                }
            )
        );

    /// <summary>SceneUpdate: a line for each lane line in the image.</summary>
    public byte[] Lanes(LanesLabel lanes) =>
        Scene(update =>
            update.Messages(
                2,
                lanes.Lines.Select((line, index) => (line, index)),
                (entity, item) =>
                {
                    Time(entity, 1);
                    entity
                        .Text(2, World)
                        .Text(3, $"{item.index}")
                        .Messages(6, Facts(item.line), (pair, fact) => Pair(pair, fact.Name, fact.Value));
                    entity.Message(
                        11,
                        line =>
                            line.Message(2, pose => Pose(pose, Vector3D.Zero, Rotation.None))
                                .Number(3, LaneThicknessMetres)
                                .Messages(5, item.line.Points, (point, at) => Vector(point, at.World))
                                .Message(6, colour => Paint(colour, LaneColour))
                    );
                }
            )
        );

    /// <summary>ImageAnnotations: boxes with captions, joints and lane lines, pixels.</summary>
    public byte[] Annotations(IReadOnlyList<ExportObject> objects) =>
        ProtoMessage.Of(message =>
        {
            message
                .Messages(
                    2,
                    objects,
                    (points, item) =>
                        Drawing(points, LineLoop, Corners(item.Box), ClassColours.Of(item.Label.Class), LineThicknessPixels, Facts(item))
                )
                .Messages(
                    2,
                    objects.Where(item => item.Label.Joints is not null),
                    (points, item) =>
                        Drawing(
                            points,
                            Points,
                            item.Label.Joints!.Joints.Where(joint => joint.Pixel is not null).Select(joint => joint.Pixel!.Value),
                            JointColour,
                            PointThicknessPixels,
                            Facts(item)
                        )
                )
                .Messages(
                    2,
                    label.Lanes?.Lines ?? [],
                    (points, line) =>
                        Drawing(points, LineStrip, line.Points.Select(point => point.Pixel), LaneColour, LineThicknessPixels, Facts(line))
                )
                .Messages(
                    3,
                    objects,
                    (text, item) =>
                    {
                        Time(text, 1);
                        text.Message(2, position => Point(position, new Vector2D(item.Box.XMin, item.Box.YMin)))
                            .Text(3, item.Class.Name)
                            .Number(4, FontPixels)
                            .Message(5, colour => Paint(colour, ClassColours.Of(item.Label.Class)));
                    }
                );
            Time(message, 5);
        });

    private byte[] Scene(Action<ProtoMessage> entities) =>
        ProtoMessage.Of(update =>
        {
            update.Message(
                1,
                deletion =>
                {
                    Time(deletion, 1);
                    deletion.Integer(2, DeleteAll);
                }
            );
            entities(update);
        });

    private void Drawing(
        ProtoMessage drawing,
        int type,
        IEnumerable<Vector2D> points,
        int colour,
        double thickness,
        IEnumerable<(string Name, string Value)> facts
    )
    {
        Time(drawing, 1);
        drawing
            .Integer(2, type)
            .Messages(3, points, Point)
            .Message(4, outline => Paint(outline, colour))
            .Number(7, thickness)
            .Messages(8, facts, (pair, fact) => Pair(pair, fact.Name, fact.Value));
    }

    private static IEnumerable<(string Name, string Value)> Facts(ExportObject item)
    {
        ObjectLabel label = item.Label;
        yield return ("id", $"{label.Id}");
        yield return ("class", item.Class.Name);
        yield return ("model", label.Model);
        if (label.Name is { } name)
        {
            yield return ("name", name);
        }

        yield return ("truncatedFraction", FormattableString.Invariant($"{label.TruncatedFraction:0.###}"));
        if (label.OccludedFraction is { } occluded)
        {
            yield return ("occludedFraction", FormattableString.Invariant($"{occluded:0.###}"));
        }
    }

    private static IEnumerable<(string Name, string Value)> Facts(LaneLineView line) =>
        [
            ("index", FormattableString.Invariant($"{line.Index}")),
            .. line.Paint is { } paint
                ? [("style", paint.Style.ToString()), ("colour", paint.Colour.ToString())]
                : Array.Empty<(string, string)>(),
        ];

    private static Vector2D[] Corners(Box2D box) =>
        [new(box.XMin, box.YMin), new(box.XMax, box.YMin), new(box.XMax, box.YMax), new(box.XMin, box.YMax)];

    private static void Pair(ProtoMessage message, string key, string value) => message.Text(1, key).Text(2, value);

    private static void Point(ProtoMessage message, Vector2D point) => message.Number(1, point.X).Number(2, point.Y);

    private static void Vector(ProtoMessage message, Vector3D vector) =>
        message.Number(1, vector.X).Number(2, vector.Y).Number(3, vector.Z);

    private static void Quaternion(ProtoMessage message, Rotation rotation) =>
        message.Number(1, rotation.X).Number(2, rotation.Y).Number(3, rotation.Z).Number(4, rotation.W);

    private static void Pose(ProtoMessage message, Vector3D position, Rotation rotation) =>
        message.Message(1, vector => Vector(vector, position)).Message(2, quaternion => Quaternion(quaternion, rotation));

    /// <summary>A Color.</summary>
    /// <param name="message">The message.</param>
    /// <param name="colour">0xRRGGBB.</param>
    /// <param name="opacity">0 to 1.</param>
    private static void Paint(ProtoMessage message, int colour, double opacity = 1) =>
        message
            .Number(1, ((colour >> 16) & 0xFF) / 255.0)
            .Number(2, ((colour >> 8) & 0xFF) / 255.0)
            .Number(3, (colour & 0xFF) / 255.0)
            .Number(4, opacity);

    private void Time(ProtoMessage message, int field) => Time(message, field, nanoseconds);
}
