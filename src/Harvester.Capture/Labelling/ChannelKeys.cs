namespace Harvester.Capture.Labelling;

/// <summary>A set of channels by their keys. Two sets with the same keys are equal.</summary>
public sealed class ChannelKeys : IEquatable<ChannelKeys>
{
    private readonly string[] _keys;

    /// <summary>Creates a set.</summary>
    public ChannelKeys(IEnumerable<string> keys) =>
        _keys = [.. (keys ?? throw new ArgumentNullException(nameof(keys))).Distinct().OrderBy(static key => key, StringComparer.Ordinal)];

    /// <summary>The empty set.</summary>
    public static ChannelKeys None { get; } = new([]);

    /// <summary>The keys, in alphabetical order.</summary>
    public IReadOnlyList<string> Keys => _keys;

    /// <summary>Whether a channel is in the set.</summary>
    public bool Contains(string key) => _keys.Contains(key);

    /// <summary>The set with or without a channel.</summary>
    public ChannelKeys With(string key, bool isIn) => new([.. _keys.Where(each => each != key), .. isIn ? [key] : Array.Empty<string>()]);

    /// <inheritdoc />
    public bool Equals(ChannelKeys? other) => other is not null && _keys.SequenceEqual(other._keys);

    /// <inheritdoc />
    public override bool Equals(object? obj) => Equals(obj as ChannelKeys);

    /// <inheritdoc />
    public override int GetHashCode() => ToString().GetHashCode();

    /// <inheritdoc />
    public override string ToString() => string.Join(", ", _keys);
}
