using Harvester.Sessions.Text;

namespace Harvester.Capture.Labelling;

/// <summary>Divides the frames of a session evenly among the places that it visits one after another.</summary>
public sealed record PlaceSequence
{
    private readonly int _frames;

    /// <summary>Divides frames among places; each place has at least one frame.</summary>
    /// <param name="frames">Number of frames of the session, those of other shards included; at least 1.</param>
    /// <param name="places">Number of places, 1 to the number of frames.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    public PlaceSequence(int frames, int places)
    {
        _frames = OptionCheck.InRange(frames, 1, int.MaxValue, nameof(frames));
        Count = OptionCheck.InRange(places, 1, frames, nameof(places));
    }

    /// <summary>Number of places.</summary>
    public int Count { get; }

    /// <summary>
    /// Number of views of each moment, which stay at one place; 1 without a rig. With more, the frames that the sequence was made for are
    /// moments.
    /// </summary>
    public int ViewsPerMoment
    {
        get;
        init => field = OptionCheck.InRange(value, 1, int.MaxValue, nameof(ViewsPerMoment));
    } = 1;

    /// <summary>The place of a frame, from 0.</summary>
    /// <param name="frame">Number of the frame in the session.</param>
    public int PlaceOf(int frame) => (int)(((((frame / ViewsPerMoment) + 1L) * Count) - 1) / _frames);

    /// <summary>The number of the first frame of a place.</summary>
    /// <param name="place">Number of the place; the number of places gives the number of frames.</param>
    public int FirstFrameOf(int place) => (int)((long)place * _frames / Count) * ViewsPerMoment;
}
