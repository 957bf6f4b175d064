"""Reads MCAP files from the specification (mcap.dev/spec), with every index and checksum, and their messages by the schemas in them."""

import struct
import zlib

from google.protobuf import descriptor_pb2, descriptor_pool, message_factory

MAGIC = b"\x89MCAP0\r\n"


def u16(data, at):
    return struct.unpack_from("<H", data, at)[0]


def u32(data, at):
    return struct.unpack_from("<I", data, at)[0]


def u64(data, at):
    return struct.unpack_from("<Q", data, at)[0]


def text(data, at):
    length = u32(data, at)
    return data[at + 4 : at + 4 + length].decode(), at + 4 + length


def records(data, at, end):
    """Start, kind and content of the records in a range."""
    while at < end:
        length = u64(data, at + 1)
        assert at + 9 + length <= end
        yield at, data[at], data[at + 9 : at + 9 + length]
        at += 9 + length


def message_class(schema):
    descriptors = descriptor_pb2.FileDescriptorSet.FromString(schema["data"])
    pool = descriptor_pool.DescriptorPool()
    for file in descriptors.file:
        pool.Add(file)
    descriptor = pool.FindMessageTypeByName(schema["name"])
    if hasattr(message_factory, "GetMessageClass"):
        return message_factory.GetMessageClass(descriptor)
    return message_factory.MessageFactory(pool).GetPrototype(descriptor)


def definitions(all_records):
    schemas, channels = {}, {}
    for _, kind, content in all_records:
        if kind == 3:
            name, at = text(content, 2)
            encoding, at = text(content, at)
            assert encoding == "protobuf" and u32(content, at) == len(content) - at - 4
            schemas[u16(content, 0)] = {"name": name, "data": content[at + 4 :]}
        elif kind == 4:
            topic, at = text(content, 4)
            encoding, at = text(content, at)
            assert encoding == "protobuf"
            channels[u16(content, 0)] = (topic, message_class(schemas[u16(content, 2)]))
    return schemas, channels


def read(path):
    """The messages by topic, as pairs of time in nanoseconds and message; found by the indexes of the summary, as readers do."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == MAGIC and data[-8:] == MAGIC
    footer_at = len(data) - 8 - 9 - 20
    assert data[footer_at] == 2
    summary_at, offsets_at, crc = u64(data, footer_at + 9), u64(data, footer_at + 17), u32(data, footer_at + 25)
    assert crc == zlib.crc32(data[summary_at : footer_at + 25])
    assert data[summary_at - 13] == 0x0F and u32(data, summary_at - 4) == zlib.crc32(data[: summary_at - 13])

    top = list(records(data, 8, footer_at))
    body = [record for record in top if record[0] < summary_at]
    summary = [record for record in top if summary_at <= record[0] < offsets_at]
    assert [definitions(part)[0] for part in (body, summary)] == [definitions(summary)[0]] * 2
    assert [kind for _, kind, _ in summary] == sorted((kind for _, kind, _ in summary), key=(3, 4, 0x0B, 8).index)
    channels = definitions(summary)[1]

    messages = {topic: [] for topic, _ in channels.values()}
    counts = {}
    for _, _, index in (record for record in summary if record[1] == 8):
        start, end, at, length = (u64(index, 8 * i) for i in range(4))
        chunk = data[at + 9 : at + length]
        assert data[at] == 6 and (u64(chunk, 0), u64(chunk, 8)) == (start, end) and u32(chunk, 28) == 0
        content = chunk[40:]
        assert u64(chunk, 16) == u64(chunk, 32) == len(content) and u32(chunk, 24) == zlib.crc32(content)
        entries = u32(index, 32)
        seen = 0
        for place in range(36, 36 + entries, 10):
            channel, index_at = u16(index, place), u64(index, place + 2)
            assert data[index_at] == 7 and u16(data, index_at + 9) == channel
            for entry in range(index_at + 15, index_at + 15 + u32(data, index_at + 11), 16):
                time, offset = u64(data, entry), u64(data, entry + 8)
                assert start <= time <= end and content[offset] == 5 and u16(content, offset + 9) == channel
                assert u64(content, offset + 15) == time
                topic, kind = channels[channel]
                messages[topic].append(
                    (time, kind.FromString(content[offset + 31 : offset + 9 + u64(content, offset + 1)]))
                )
                counts[channel] = counts.get(channel, 0) + 1
                seen += 1
        assert seen == sum(1 for _ in records(content, 0, len(content)))
    statistics = next(content for _, kind, content in summary if kind == 0x0B)
    assert u64(statistics, 0) == sum(counts.values())
    at = 8 + 2 + 4 * 4 + 16
    listed = {
        u16(statistics, place): u64(statistics, place + 2) for place in range(at + 4, at + 4 + u32(statistics, at), 10)
    }
    assert listed == counts
    return messages
