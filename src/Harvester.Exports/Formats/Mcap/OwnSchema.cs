using Google.Protobuf.Reflection;
using static Google.Protobuf.Reflection.FieldDescriptorProto.Types;
using TimestampReflection = Google.Protobuf.WellKnownTypes.TimestampReflection;
using Type = Google.Protobuf.Reflection.FieldDescriptorProto.Types.Type;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>Describes messages for which Foxglove has no schema, in a package of their own.</summary>
internal static class OwnSchema
{
    /// <summary>The package.</summary>
    public const string Package = "gtaharvest";

    private const string Timestamp = "google.protobuf.Timestamp";

    /// <summary>The file of a message, which imports the messages of its fields.</summary>
    /// <param name="fullName">Name of the message with its package.</param>
    /// <param name="fields">Its fields. In proto3, presence of a number is a group (oneof) with one member.</param>
    public static FileDescriptorProto File(string fullName, params FieldDescriptorProto[] fields)
    {
        var message = new DescriptorProto { Name = fullName[(Package.Length + 1)..] };
        foreach (FieldDescriptorProto field in fields.Where(field => field.Proto3Optional))
        {
            field.OneofIndex = message.OneofDecl.Count;
            message.OneofDecl.Add(new OneofDescriptorProto { Name = "_" + field.Name });
        }

        message.Field.AddRange(fields);
        var file = new FileDescriptorProto
        {
            Name = FileOf(fullName),
            Package = Package,
            Syntax = "proto3",
        };
        file.MessageType.Add(message);
        file.Dependency.AddRange(fields.Where(field => field.Type == Type.Message).Select(field => FileOf(field.TypeName[1..])).Distinct());
        return file;
    }

    public static FieldDescriptorProto Time(int number) => Message("timestamp", number, Timestamp);

    public static FieldDescriptorProto Number(string name, int number) => Field(name, number, Type.Double);

    /// <summary>A number that is absent if it is unknown.</summary>
    public static FieldDescriptorProto OptionalNumber(string name, int number)
    {
        FieldDescriptorProto field = Number(name, number);
        field.Proto3Optional = true;
        return field;
    }

    public static FieldDescriptorProto Text(string name, int number) => Field(name, number, Type.String);

    public static FieldDescriptorProto Boolean(string name, int number) => Field(name, number, Type.Bool);

    /// <summary>A message, which may be absent.</summary>
    public static FieldDescriptorProto Message(string name, int number, string fullName)
    {
        FieldDescriptorProto field = Field(name, number, Type.Message);
        field.TypeName = "." + fullName;
        return field;
    }

    private static FieldDescriptorProto Field(string name, int number, Type type) =>
        new()
        {
            Name = name,
            Number = number,
            Type = type,
            Label = Label.Optional,
        };

    private static string FileOf(string message) =>
        message == Timestamp ? TimestampReflection.Descriptor.Name : message.Replace('.', '/') + ".proto";
}
