using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>
/// Places at which borders of lanes begin and end. Those that are joined are one, in the middle between them unless it is moved.
/// </summary>
internal sealed class MeetingPoints
{
    private readonly List<int> _groups = [];
    private readonly List<Vector3D> _sums = [];
    private readonly List<int> _counts = [];
    private readonly HashSet<int> _moved = [];

    /// <summary>Adds a place, and returns its number.</summary>
    public int Add(Vector3D place)
    {
        _groups.Add(_groups.Count);
        _sums.Add(place);
        _counts.Add(1);
        return _groups.Count - 1;
    }

    /// <summary>Makes two places one.</summary>
    public void Join(int one, int other)
    {
        (int first, int second) = (GroupOf(one), GroupOf(other));
        if (first != second)
        {
            (int kept, int gone) = (Math.Min(first, second), Math.Max(first, second));
            _groups[gone] = kept;
            _sums[kept] += _sums[gone];
            _counts[kept] += _counts[gone];
        }
    }

    /// <summary>The least number of the places that are one with a place.</summary>
    public int GroupOf(int place)
    {
        while (_groups[place] != place)
        {
            // Halves the path to the first place of the group.
            _groups[place] = _groups[_groups[place]];
            place = _groups[place];
        }

        return place;
    }

    /// <summary>Where a place is, metres, world.</summary>
    public Vector3D PositionOf(int place)
    {
        int group = GroupOf(place);
        return _counts[group] == 1 ? _sums[group] : _sums[group] * (1.0 / _counts[group]);
    }

    /// <summary>Moves a place, and those that are one with it.</summary>
    public void Move(int place, Vector3D to)
    {
        int group = GroupOf(place);
        (_sums[group], _counts[group]) = (to, 1);
        _moved.Add(group);
    }

    /// <summary>Whether a place was moved.</summary>
    public bool IsMoved(int place) => _moved.Contains(GroupOf(place));
}
