namespace Harvester.Exports.Formats.OpenLabel;

/// <summary>The runs of frames in which an object occurs.</summary>
internal sealed class FrameIntervals
{
    private readonly List<(int Start, int End)> _runs = [];

    /// <summary>Adds a frame, in rising order.</summary>
    public void Add(int frame)
    {
        if (_runs.Count > 0 && _runs[^1].End == frame - 1)
        {
            _runs[^1] = (_runs[^1].Start, frame);
        }
        else
        {
            _runs.Add((frame, frame));
        }
    }

    /// <summary>The runs as JSON; both ends belong to a run.</summary>
    public override string ToString() =>
        "["
        + string.Join(',', _runs.ConvertAll(run => FormattableString.Invariant($"{{\"frame_start\":{run.Start},\"frame_end\":{run.End}}}")))
        + "]";
}
