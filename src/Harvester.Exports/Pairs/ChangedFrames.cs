using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Pairs;

/// <summary>The frames of a changed run, compared with those of the base byte by byte.</summary>
internal sealed class ChangedFrames : IDisposable
{
    private readonly IEnumerator<LabelLine> _lines;
    private bool _hasLine;

    public ChangedFrames(ChangedRun run, SessionReader session)
    {
        (Run, Session, _lines) = (run, session, session.ReadGoodLines().GetEnumerator());
        _hasLine = _lines.MoveNext();
    }

    public ChangedRun Run { get; }

    public SessionReader Session { get; }

    /// <summary>Number of the first frame whose label differs from that of the base; null if none does.</summary>
    public int? FirstLabel { get; private set; }

    /// <summary>Number of the first frame whose image differs from that of the base; null if none does.</summary>
    public int? FirstImage { get; private set; }

    /// <summary>
    /// Compares the frame with the number of a frame of the base; null if this run lacks it. Frames are asked for in order.
    /// </summary>
    public (LabelLine Line, bool Label, bool Image)? Compare(SessionReader original, LabelLine line)
    {
        int frame = line.Label!.Frame;
        while (_hasLine && _lines.Current.Label!.Frame < frame)
        {
            _hasLine = _lines.MoveNext();
        }

        if (!_hasLine || _lines.Current.Label!.Frame != frame)
        {
            return null;
        }

        LabelLine own = _lines.Current;
        bool label = own.Text != line.Text;
        bool image = FileDigest.OfFile(Session.PathOf(own.Label!.Image)) != FileDigest.OfFile(original.PathOf(line.Label.Image));
        FirstLabel ??= label ? frame : null;
        FirstImage ??= image ? frame : null;
        return (own, label, image);
    }

    public void Dispose() => _lines.Dispose();
}
