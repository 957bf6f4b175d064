namespace Harvester.Exports.Maps;

/// <summary>A border as a lane has it.</summary>
/// <param name="Border">The border.</param>
/// <param name="IsReversed">Whether it runs against the lane.</param>
internal readonly record struct BorderSide(LaneBorder Border, bool IsReversed)
{
    /// <summary>The place at which it starts in the lane's direction.</summary>
    public int Start => IsReversed ? Border.End : Border.Start;

    /// <summary>The place at which it ends in the lane's direction.</summary>
    public int End => IsReversed ? Border.Start : Border.End;

    /// <summary>Its nodes in the lane's direction.</summary>
    public IEnumerable<int> Nodes => IsReversed ? Border.Nodes.Reverse() : Border.Nodes;
}
