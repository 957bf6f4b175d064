namespace Harvester.Exports.Maps;

/// <summary>What a border of lanes lies between.</summary>
internal enum LaneBorderKind
{
    /// <summary>A lane, and no lane beside it.</summary>
    Edge,

    /// <summary>Two lanes of the same direction.</summary>
    Divider,

    /// <summary>Two lanes of opposite directions.</summary>
    Centre,

    /// <summary>The edge of a way through a junction, where nothing is painted.</summary>
    Junction,
}
