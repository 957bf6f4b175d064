using Harvester.Capture.Harvesting;

namespace Harvester.Benchmarks.Occlusion;

/// <summary>Holds a session's last frame until it is taken.</summary>
internal sealed class OneFrameSink : IFrameSink
{
    private CapturedFrame? _frame;

    public int FirstFrame => 0;

    public int FirstObjectId => 1;

    public int FirstEventId => 1;

    public bool HasRoom => _frame is null;

    public string? Fault => null;

    public void Open(SessionStart start) { }

    public bool TryEnqueue(CapturedFrame frame)
    {
        if (_frame is not null)
        {
            return false;
        }

        _frame = frame;
        return true;
    }

    /// <summary>The frame held; null if there is none. The caller disposes it.</summary>
    public CapturedFrame? Take() => (_frame, _frame = null).Item1;

    public void Close(SessionEnd end) { }

    public void Dispose() => _frame?.Dispose();
}
