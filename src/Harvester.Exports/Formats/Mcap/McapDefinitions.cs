namespace Harvester.Exports.Formats.Mcap;

/// <summary>The records that define channels and their schemas.</summary>
/// <param name="Channels">The channels.</param>
/// <param name="Schemas">Full names of the schemas.</param>
internal sealed record McapDefinitions(IReadOnlyList<McapChannel> Channels, IReadOnlyList<string> Schemas)
{
    /// <summary>Those of every file.</summary>
    public static McapDefinitions OfSessions { get; } = new(McapChannel.OfSessions, NamesOf(McapChannel.OfSessions));

    /// <summary>Those that a recorded drive adds.</summary>
    public static McapDefinitions OfDrives { get; } =
        new(McapChannel.OfDrives, [.. NamesOf(McapChannel.OfDrives).Except(OfSessions.Schemas)]);

    /// <summary>Those that events add.</summary>
    public static McapDefinitions OfEvents { get; } = new(McapChannel.OfEvents, NamesOf(McapChannel.OfEvents));

    /// <summary>Those that bird's-eye maps add.</summary>
    public static McapDefinitions OfGrids { get; } = new(McapChannel.OfGrids, NamesOf(McapChannel.OfGrids));

    /// <summary>Those that only some files have, in the order of their numbers; a file has them from their first message on.</summary>
    public static IReadOnlyList<McapDefinitions> OfSome { get; } = [OfDrives, OfEvents, OfGrids];

    /// <summary>Whether a channel, by its number, is one of these.</summary>
    public bool Has(int id) => Channels.Any(channel => channel.Id == id);

    /// <summary>These and others.</summary>
    public McapDefinitions With(McapDefinitions others) => new([.. Channels, .. others.Channels], [.. Schemas, .. others.Schemas]);

    public byte[] SchemaRecords() =>
        [
            .. Schemas.SelectMany(name =>
            {
                using var schema = new McapRecord(McapOpcode.Schema);
                byte[] descriptors = MessageSchemas.DescriptorsOf(name);
                return schema.UInt16(NumberOf(name)).Text(name).Text("protobuf").UInt32(descriptors.Length).Bytes(descriptors).ToArray();
            }),
        ];

    public byte[] ChannelRecords() =>
        [
            .. Channels.SelectMany(channel =>
            {
                using var record = new McapRecord(McapOpcode.Channel);
                return record.UInt16(channel.Id).UInt16(NumberOf(channel.Schema)).Text(channel.Topic).Text("protobuf").UInt32(0).ToArray();
            }),
        ];

    private static string[] NamesOf(IEnumerable<McapChannel> channels) =>
        [.. channels.Select(channel => channel.Schema).Distinct(StringComparer.Ordinal)];

    private static int NumberOf(string schema) => MessageSchemas.Names.TakeWhile(name => name != schema).Count() + 1;
}
