namespace Harvester.Exports.Formats.Columns;

/// <summary>A structure of Thrift's compact protocol, of which the needed fields are asked for by their numbers.</summary>
/// <param name="fields">The fields.</param>
internal sealed class ThriftStruct(IReadOnlyDictionary<int, object> fields)
{
    /// <summary>A whole number; null if it is missing.</summary>
    public long? Number(int field) => fields.GetValueOrDefault(field) as long?;

    /// <summary>A text; null if it is missing.</summary>
    public string? Text(int field) => fields.GetValueOrDefault(field) as string;

    /// <summary>A structure; null if it is missing.</summary>
    public ThriftStruct? Struct(int field) => fields.GetValueOrDefault(field) as ThriftStruct;

    /// <summary>The structures of a list; empty if it is missing.</summary>
    public IEnumerable<ThriftStruct> Structs(int field) => (fields.GetValueOrDefault(field) as List<object> ?? []).OfType<ThriftStruct>();

    /// <summary>The texts of a list; empty if it is missing.</summary>
    public IEnumerable<string> Texts(int field) => (fields.GetValueOrDefault(field) as List<object> ?? []).OfType<string>();
}
