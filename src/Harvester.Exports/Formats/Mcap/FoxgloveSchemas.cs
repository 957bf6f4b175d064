using Google.Protobuf;
using Google.Protobuf.Reflection;
using static Google.Protobuf.Reflection.FieldDescriptorProto.Types;
using DurationReflection = Google.Protobuf.WellKnownTypes.DurationReflection;
using TimestampReflection = Google.Protobuf.WellKnownTypes.TimestampReflection;
using Type = Google.Protobuf.Reflection.FieldDescriptorProto.Types.Type;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// The protobuf schemas of the channels: Foxglove's, so that its app and others show the messages (docs.foxglove.dev, "Message schemas";
/// names, numbers and types of the fields in github.com/foxglove/foxglove-sdk), and those of the lane indicators and of recorded drives.
/// </summary>
internal static class FoxgloveSchemas
{
    private const string Package = "foxglove";

    private static readonly Dictionary<string, FileDescriptorProto> Files = Describe();

    /// <summary>Full names of the messages of the channels, each once.</summary>
    public static IReadOnlyList<string> Names { get; } =
    [.. McapChannel.All.Select(channel => channel.Schema).Distinct(StringComparer.Ordinal)];

    /// <summary>A serialised FileDescriptorSet with the file of a message after all files that it imports.</summary>
    public static byte[] DescriptorsOf(string message)
    {
        var set = new FileDescriptorSet();
        Add(Files[FileOf(message)]);
        return set.ToByteArray();

        void Add(FileDescriptorProto file)
        {
            foreach (string import in file.Dependency)
            {
                Add(Files[import]);
            }

            if (!set.File.Contains(file))
            {
                set.File.Add(file);
            }
        }
    }

    private static string FileOf(string message) => message.Replace('.', '/') + ".proto";

    private static Dictionary<string, FileDescriptorProto> Describe()
    {
        FileDescriptorProto[] files =
        [
            WellKnown(TimestampReflection.Descriptor),
            WellKnown(DurationReflection.Descriptor),
            File("Vector3", Numbers("x", "y", "z")),
            File("Point3", Numbers("x", "y", "z")),
            File("Point2", Numbers("x", "y")),
            File("Quaternion", Numbers("x", "y", "z", "w")),
            File("Color", Numbers("r", "g", "b", "a")),
            File("Pose", [Field("position", 1, "Vector3"), Field("orientation", 2, "Quaternion")]),
            File("KeyValuePair", [Field("key", 1, Type.String), Field("value", 2, Type.String)]),
            File(
                "CompressedImage",
                [Time(1), Field("frame_id", 4, Type.String), Field("data", 2, Type.Bytes), Field("format", 3, Type.String)]
            ),
            File(
                "CameraCalibration",
                [
                    Time(1),
                    Field("frame_id", 9, Type.String),
                    Field("width", 2, Type.Fixed32),
                    Field("height", 3, Type.Fixed32),
                    Field("distortion_model", 4, Type.String),
                    List("D", 5),
                    List("K", 6),
                    List("R", 7),
                    List("P", 8),
                ]
            ),
            File(
                "FrameTransform",
                [
                    Time(1),
                    Field("parent_frame_id", 2, Type.String),
                    Field("child_frame_id", 3, Type.String),
                    Field("translation", 4, "Vector3"),
                    Field("rotation", 5, "Quaternion"),
                ]
            ),
            File("FrameTransforms", [Repeated("transforms", 1, "FrameTransform")]),
            File(
                "SceneEntityDeletion",
                [Time(1), Enumeration("type", 2, "SceneEntityDeletion.Type"), Field("id", 3, Type.String)],
                Values("Type", "MATCHING_ID", "ALL")
            ),
            File("CubePrimitive", [Field("pose", 1, "Pose"), Field("size", 2, "Vector3"), Field("color", 3, "Color")]),
            File(
                "LinePrimitive",
                [
                    Enumeration("type", 1, "LinePrimitive.Type"),
                    Field("pose", 2, "Pose"),
                    Field("thickness", 3, Type.Double),
                    Field("scale_invariant", 4, Type.Bool),
                    Repeated("points", 5, "Point3"),
                    Field("color", 6, "Color"),
                    Repeated("colors", 7, "Color"),
                    List("indices", 8, Type.Fixed32),
                ],
                Values("Type", "LINE_STRIP", "LINE_LOOP", "LINE_LIST")
            ),
            File(
                "TextPrimitive",
                [
                    Field("pose", 1, "Pose"),
                    Field("billboard", 2, Type.Bool),
                    Field("font_size", 3, Type.Double),
                    Field("scale_invariant", 4, Type.Bool),
                    Field("color", 5, "Color"),
                    Field("text", 6, Type.String),
                ]
            ),
            File(
                "SceneEntity",
                [
                    Time(1),
                    Field("frame_id", 2, Type.String),
                    Field("id", 3, Type.String),
                    External("lifetime", 4, "google.protobuf.Duration"),
                    Field("frame_locked", 5, Type.Bool),
                    Repeated("metadata", 6, "KeyValuePair"),
                    Repeated("cubes", 8, "CubePrimitive"),
                    Repeated("lines", 11, "LinePrimitive"),
                    Repeated("texts", 13, "TextPrimitive"),
                ]
            ),
            File("SceneUpdate", [Repeated("deletions", 1, "SceneEntityDeletion"), Repeated("entities", 2, "SceneEntity")]),
            File(
                "PointsAnnotation",
                [
                    Time(1),
                    Enumeration("type", 2, "PointsAnnotation.Type"),
                    Repeated("points", 3, "Point2"),
                    Field("outline_color", 4, "Color"),
                    Repeated("outline_colors", 5, "Color"),
                    Field("fill_color", 6, "Color"),
                    Field("thickness", 7, Type.Double),
                    Repeated("metadata", 8, "KeyValuePair"),
                ],
                Values("Type", "UNKNOWN", "POINTS", "LINE_LOOP", "LINE_STRIP", "LINE_LIST")
            ),
            File(
                "TextAnnotation",
                [
                    Time(1),
                    Field("position", 2, "Point2"),
                    Field("text", 3, Type.String),
                    Field("font_size", 4, Type.Double),
                    Field("text_color", 5, "Color"),
                    Field("background_color", 6, "Color"),
                    Repeated("metadata", 7, "KeyValuePair"),
                ]
            ),
            File(
                "ImageAnnotations",
                [
                    Repeated("points", 2, "PointsAnnotation"),
                    Repeated("texts", 3, "TextAnnotation"),
                    Repeated("metadata", 4, "KeyValuePair"),
                    Time(5),
                ]
            ),
            IndicatorMessage.Describe(),
            .. DriveMessages.Describe(),
        ];
        return files.ToDictionary(file => file.Name, StringComparer.Ordinal);
    }

    private static FileDescriptorProto WellKnown(FileDescriptor file) => FileDescriptorProto.Parser.ParseFrom(file.SerializedData);

    /// <summary>The file of a message, which imports the messages of its fields.</summary>
    private static FileDescriptorProto File(string name, FieldDescriptorProto[] fields, params EnumDescriptorProto[] enumerations)
    {
        var message = new DescriptorProto { Name = name };
        message.Field.AddRange(fields);
        message.EnumType.AddRange(enumerations);
        var file = new FileDescriptorProto
        {
            Name = $"{Package}/{name}.proto",
            Package = Package,
            Syntax = "proto3",
        };
        file.MessageType.Add(message);
        file.Dependency.AddRange(fields.Where(field => field.Type == Type.Message).Select(field => ImportOf(field.TypeName)).Distinct());
        return file;
    }

    private static string ImportOf(string typeName) =>
        typeName switch
        {
            ".google.protobuf.Timestamp" => "google/protobuf/timestamp.proto",
            ".google.protobuf.Duration" => "google/protobuf/duration.proto",
            _ => FileOf(typeName[1..]),
        };

    private static FieldDescriptorProto[] Numbers(params string[] names) =>
        [.. names.Select((name, index) => Field(name, index + 1, Type.Double))];

    private static FieldDescriptorProto Time(int number) => External("timestamp", number, "google.protobuf.Timestamp");

    private static FieldDescriptorProto Field(string name, int number, Type type) =>
        new()
        {
            Name = name,
            Number = number,
            Type = type,
            Label = Label.Optional,
        };

    private static FieldDescriptorProto List(string name, int number, Type type = Type.Double) =>
        new()
        {
            Name = name,
            Number = number,
            Type = type,
            Label = Label.Repeated,
        };

    private static FieldDescriptorProto Field(string name, int number, string message) => External(name, number, $"{Package}.{message}");

    private static FieldDescriptorProto External(string name, int number, string fullName) =>
        new()
        {
            Name = name,
            Number = number,
            Type = Type.Message,
            TypeName = "." + fullName,
            Label = Label.Optional,
        };

    private static FieldDescriptorProto Repeated(string name, int number, string message)
    {
        FieldDescriptorProto field = Field(name, number, message);
        field.Label = Label.Repeated;
        return field;
    }

    private static FieldDescriptorProto Enumeration(string name, int number, string type) =>
        new()
        {
            Name = name,
            Number = number,
            Type = Type.Enum,
            TypeName = $".{Package}.{type}",
            Label = Label.Optional,
        };

    private static EnumDescriptorProto Values(string name, params string[] values)
    {
        var enumeration = new EnumDescriptorProto { Name = name };
        enumeration.Value.AddRange(values.Select((value, number) => new EnumValueDescriptorProto { Name = value, Number = number }));
        return enumeration;
    }
}
