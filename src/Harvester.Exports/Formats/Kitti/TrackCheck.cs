namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// Checks the lines of a sequence in order: frame numbers do not decrease, and a track id stands for one object of one type.
/// </summary>
internal sealed class TrackCheck
{
    private readonly Dictionary<string, string> _types = new(StringComparer.Ordinal);
    private readonly HashSet<string> _inFrame = new(StringComparer.Ordinal);
    private int _frame;

    public string? ProblemOf(int frame, string track, string type)
    {
        if (frame < _frame)
        {
            return $"frame {frame} comes after frame {_frame}.";
        }

        if (frame > _frame)
        {
            _inFrame.Clear();
        }

        _frame = frame;
        return type == KittiClasses.DontCare ? null
            : !_inFrame.Add(track) ? $"track {track} occurs twice in frame {frame}."
            : !_types.TryAdd(track, type) && _types[track] != type
                ? $"track {track} is {type}, but was {_types[track]} in an earlier frame."
            : null;
    }
}
