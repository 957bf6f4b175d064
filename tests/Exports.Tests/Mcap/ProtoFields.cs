using Google.Protobuf;

namespace Harvester.Exports.Tests.Mcap;

/// <summary>The fields of a protobuf message by their numbers, read without a schema.</summary>
internal sealed class ProtoFields
{
    private readonly Dictionary<int, object> _values = [];

    public ProtoFields(byte[] message)
    {
        using var input = new CodedInputStream(message);
        while (input.ReadTag() is not 0 and uint tag)
        {
            _values[WireFormat.GetTagFieldNumber(tag)] = WireFormat.GetTagWireType(tag) switch
            {
                WireFormat.WireType.Varint => input.ReadInt64(),
                WireFormat.WireType.Fixed64 => input.ReadDouble(),
                _ => input.ReadBytes().ToByteArray(),
            };
        }
    }

    public bool Has(int field) => _values.ContainsKey(field);

    /// <summary>A number, 0 if it is absent.</summary>
    public double Number(int field) => Convert.ToDouble(_values.GetValueOrDefault(field, 0.0), null);

    public string Text(int field) => System.Text.Encoding.UTF8.GetString((byte[])_values.GetValueOrDefault(field, Array.Empty<byte>()));

    public ProtoFields Inner(int field) => new((byte[])_values[field]);

    /// <summary>Numbers of an inner message.</summary>
    public double[] Numbers(int field, int count) => [.. Enumerable.Range(1, count).Select(Inner(field).Number)];

    /// <summary>An inner timestamp, nanoseconds.</summary>
    public double Nanoseconds(int field) => (1e9 * Inner(field).Number(1)) + Inner(field).Number(2);
}
