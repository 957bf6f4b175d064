namespace Harvester.Exports.Formats.Mcap;

/// <summary>The records that define channels and their schemas (mcap.dev/spec, "Schema" and "Channel").</summary>
internal static class McapDefinitions
{
    private const string Encoding = "protobuf";
    private const int SchemaAt = McapRecord.HeadLength + sizeof(ushort);
    private const int TopicAt = SchemaAt + sizeof(ushort);

    /// <summary>The record of a schema.</summary>
    /// <param name="name">Full name of the message.</param>
    public static byte[] SchemaRecord(string name)
    {
        using var schema = new McapRecord(McapOpcode.Schema);
        byte[] descriptors = MessageSchemas.DescriptorsOf(name);
        return schema.UInt16(NumberOf(name)).Text(name).Text(Encoding).UInt32(descriptors.Length).Bytes(descriptors).ToArray();
    }

    /// <summary>The record of a channel.</summary>
    public static byte[] ChannelRecord(McapChannel channel)
    {
        using var record = new McapRecord(McapOpcode.Channel);
        return record.UInt16(channel.Id).UInt16(NumberOf(channel.Schema)).Text(channel.Topic).Text(Encoding).UInt32(0).ToArray();
    }

    /// <summary>The channel of a record that <see cref="ChannelRecord"/> made.</summary>
    /// <param name="records">Bytes that contain the record.</param>
    /// <param name="at">Where it begins.</param>
    /// <exception cref="ArgumentException">It is damaged.</exception>
    public static McapChannel ChannelAt(byte[] records, int at)
    {
        int number = BitConverter.ToUInt16(records, at + SchemaAt);
        string topic = Utf8(records, at + TopicAt);
        return number > 0 && number <= MessageSchemas.Names.Count
            ? new McapChannel(BitConverter.ToUInt16(records, at + McapRecord.HeadLength), topic, MessageSchemas.Names[number - 1])
            : throw new ArgumentException("There is no such schema.", nameof(records));
    }

    /// <summary>The number of a schema in every file, from 1.</summary>
    public static int NumberOf(string schema) => MessageSchemas.Names.TakeWhile(name => name != schema).Count() + 1;

    /// <summary>A text in a record.</summary>
    /// <exception cref="ArgumentException">It is cut off.</exception>
    public static string Utf8(byte[] bytes, int at) =>
        System.Text.Encoding.UTF8.GetString(bytes, at + sizeof(uint), BitConverter.ToInt32(bytes, at));
}
