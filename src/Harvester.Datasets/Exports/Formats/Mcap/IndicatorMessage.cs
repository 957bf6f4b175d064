using System.Linq;
using Google.Protobuf.Reflection;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using static Google.Protobuf.Reflection.FieldDescriptorProto.Types;
using TimestampReflection = Google.Protobuf.WellKnownTypes.TimestampReflection;

namespace Harvester.Datasets.Exports.Formats.Mcap;

/// <summary>
/// The message of the lane indicators: the time, the 13 values in the order of <see cref="IndicatorTable"/>, and the car's speed. A value
/// that is not active is absent.
/// </summary>
internal static class IndicatorMessage
{
    public const string SchemaName = "gtaharvest.LaneIndicators";

    private const int TimestampField = 1;
    private const int FirstIndicatorField = 2;

    private static int SpeedField => FirstIndicatorField + IndicatorTable.Count;

    /// <summary>Writes the message.</summary>
    public static byte[] Of(FrameLabel label, LanesLabel lanes, long nanoseconds) => ProtoMessage.Of(message =>
    {
        FoxgloveMessages.Time(message, TimestampField, nanoseconds);
        for (int i = 0; i < IndicatorTable.Count; i++)
        {
            if (IndicatorTable.All[i].Of(lanes.Indicators) is { IsValid: true } indicator)
            {
                message.NumberOrZero(FirstIndicatorField + i, indicator.Value);
            }
        }

        message.Number(SpeedField, label.Ego.Velocity.Length);
    });

    /// <summary>The schema: presence of a field in proto3 is a group (oneof) with one member.</summary>
    public static FileDescriptorProto Describe()
    {
        var message = new DescriptorProto { Name = "LaneIndicators" };
        message.Field.Add(new FieldDescriptorProto
        {
            Name = "timestamp",
            Number = TimestampField,
            Type = Type.Message,
            TypeName = ".google.protobuf.Timestamp",
            Label = Label.Optional,
        });
        foreach ((string name, int index) in IndicatorTable.All.Select((indicator, index) => (indicator.Name, index)))
        {
            message.Field.Add(new FieldDescriptorProto
            {
                Name = name,
                Number = FirstIndicatorField + index,
                Type = Type.Double,
                Label = Label.Optional,
                Proto3Optional = true,
                OneofIndex = index,
            });
            message.OneofDecl.Add(new OneofDescriptorProto { Name = "_" + name });
        }

        message.Field.Add(
            new FieldDescriptorProto { Name = "speed", Number = SpeedField, Type = Type.Double, Label = Label.Optional });
        var file = new FileDescriptorProto { Name = SchemaName.Replace('.', '/') + ".proto", Package = "gtaharvest", Syntax = "proto3" };
        file.MessageType.Add(message);
        file.Dependency.Add(TimestampReflection.Descriptor.Name);
        return file;
    }
}
