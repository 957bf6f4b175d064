using Harvester.Datasets.Derivation;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Assembly;

/// <summary>
/// Digests of images that are taken over from sessions: those of the sessions' manifests, so that the images need not be read and damage
/// done since stays noticeable. Frames are asked for session by session and by rising numbers.
/// </summary>
internal sealed class ImageDigests : IDisposable
{
    private SessionReader? _session;
    private CarriedDigests? _carried;

    /// <summary>The digest of a frame's image.</summary>
    /// <exception cref="System.IO.IOException">The manifest or, where it lacks the image, the image cannot be read.</exception>
    public FileDigest Of(ExportFrame frame)
    {
        if (_carried is null || _session != frame.Session)
        {
            _carried?.Dispose();
            _session = frame.Session;
            _carried = new CarriedDigests(frame.Session);
        }

        return _carried.Of(frame.Label.Frame, frame.Label.Image);
    }

    /// <inheritdoc />
    public void Dispose() => _carried?.Dispose();
}
