using Harvester.Exports.Formats.Mcap;

namespace Harvester.Exports.Tests.Mcap;

public sealed class McapFileTests
{
    private const int Messages = 10_000;
    private const int MessagesPerChunk = 5;

    [Fact]
    public void Ten_thousand_messages_come_back_byte_for_byte()
    {
        var random = new Random(1);
        (McapChannel Channel, byte[] Content)[] written =
        [
            .. Enumerable.Range(0, Messages).Select(_ => (Draw(random), Bytes(random, random.Next(0, 300)))),
        ];

        byte[] file = Write(written);

        Assert.Equal(
            written.Select(
                (message, i) =>
                    (message.Channel.Id, (uint)(i / MessagesPerChunk), Time(i / MessagesPerChunk), Convert.ToHexString(message.Content))
            ),
            McapRecords
                .Messages(file)
                .Select(message => (message.Channel, message.Sequence, message.Time, Convert.ToHexString(message.Content)))
        );
    }

    [Fact]
    public void Statistics_count_messages_chunks_schemas_and_channels()
    {
        var random = new Random(2);
        byte[] file = Write([.. Enumerable.Range(0, 20).Select(_ => (McapChannel.Image, Bytes(random, 10)))]);

        byte[] statistics = Assert.Single(McapRecords.Of(file), record => record.Kind == 0x0B).Content;

        // 20 messages, 6 schemas, 7 channels, 0 attachments, 0 metadata, 4 chunks of 5; times of chunks 0 and 3.
        Assert.Equal(20UL, BitConverter.ToUInt64(statistics));
        Assert.Equal(6, BitConverter.ToUInt16(statistics, 8));
        Assert.Equal([7u, 0u, 0u, 4u], Enumerable.Range(0, 4).Select(i => BitConverter.ToUInt32(statistics, 10 + (4 * i))));
        Assert.Equal([Time(0), Time(3)], Enumerable.Range(0, 2).Select(i => BitConverter.ToUInt64(statistics, 26 + (8 * i))));
    }

    [Fact]
    public void Summary_offsets_lead_to_groups_of_one_kind()
    {
        byte[] file = Write([(McapChannel.Image, [1]), (McapChannel.Lanes, [2])]);
        Dictionary<int, byte> kinds = McapRecords.Of(file).ToDictionary(record => record.Start, record => record.Kind);

        (int Start, byte Kind, byte[] Content)[] offsets = [.. McapRecords.Of(file).Where(record => record.Kind == 0x0E)];

        Assert.Equal([3, 4, 0x0B, 8], offsets.Select(offset => (int)offset.Content[0]));
        Assert.All(offsets, offset => Assert.Equal(offset.Content[0], kinds[(int)BitConverter.ToUInt64(offset.Content, 1)]));
    }

    private static McapChannel Draw(Random random) => McapChannel.All[random.Next(McapChannel.All.Length)];

    private static byte[] Bytes(Random random, int length)
    {
        byte[] bytes = new byte[length];
        random.NextBytes(bytes);
        return bytes;
    }

    private static ulong Time(int chunk) => 1_000_000_000UL + ((ulong)chunk * 100_000_000UL);

    private static byte[] Write((McapChannel Channel, byte[] Content)[] messages)
    {
        using var stream = new MemoryStream();
        McapFile.Write(stream, messages.Chunk(MessagesPerChunk).Select((chunk, i) => ChunkOf(i, chunk)));
        return stream.ToArray();
    }

    private static byte[] ChunkOf(int number, (McapChannel Channel, byte[] Content)[] messages)
    {
        using var stream = new MemoryStream();
        McapChunk.Write(
            stream,
            (long)Time(number),
            number,
            [.. messages.Select(message => new McapMessage(message.Channel, message.Content))]
        );
        return stream.ToArray();
    }
}
