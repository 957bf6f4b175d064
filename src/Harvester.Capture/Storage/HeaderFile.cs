using Harvester.Capture.Harvesting;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;

namespace Harvester.Capture.Storage;

/// <summary>Writes what a session has besides its frames: folders, session.json, and texts that belong to no single frame.</summary>
/// <param name="origin">Where the session comes from.</param>
/// <param name="files">The session's files.</param>
/// <param name="store">Writes the texts.</param>
/// <param name="before">What a resumed session holds.</param>
/// <param name="start">How the harvest began.</param>
internal sealed class HeaderFile(SessionOrigin origin, ISessionFiles files, FrameStore store, SessionContent before, SessionStart start)
{
    /// <summary>Whether all is written that a session needs before its first frame.</summary>
    public bool HasBegun { get; private set; }

    /// <summary>Makes the folders, and writes the header and the texts.</summary>
    /// <param name="texts">Texts by their path within the session; that of the faces is added.</param>
    /// <param name="frames">Frames that the session holds.</param>
    /// <exception cref="IOException">The session was recorded with other options, or the disk fails.</exception>
    public void Begin(List<KeyValuePair<string, string>> texts, int frames)
    {
        if (!before.IsContinuedBy(SessionJson.Text(RecordOf(null, frames))))
        {
            throw new IOException("it was recorded with other options; resume it with the same ones, or name another directory.");
        }

        foreach (string folder in FoldersOf(start.Options))
        {
            files.MakeFolder(folder);
        }

        if (before.HasManifest)
        {
            store.TidyManifest(frame => frame <= before.LastFrame, keepsReplaced: true);
        }

        if (start.Options.Scenes)
        {
            files.MakeFolder(FramePaths.Scenes);
            if (start.Options.Faces is { } faces)
            {
                texts.Add(new(FramePaths.Faces, FaceTableWriter.Text(faces)));
            }
        }

        foreach (KeyValuePair<string, string> text in texts)
        {
            store.WriteText(text.Key, text.Value);
        }

        WriteHeader(null, frames);
        HasBegun = true;
    }

    /// <summary>Writes the header of a session that has ended, and its manifest without frames that were given up.</summary>
    /// <param name="end">How the harvest ended.</param>
    /// <param name="frames">Frames that the session holds.</param>
    /// <param name="texts">Texts by their path within the session, written if it has frames.</param>
    public void Finish(SessionEnd end, int frames, IEnumerable<KeyValuePair<string, Func<string>>> texts)
    {
        foreach (KeyValuePair<string, Func<string>> text in frames > 0 ? texts : [])
        {
            store.WriteText(text.Key, text.Value());
        }

        if (end.Events is { } events)
        {
            store.FinishEvents(events);
        }

        WriteHeader(end, frames);
        int last = store.LastCommitted;
        store.TidyManifest(frame => frame <= before.LastFrame || frame <= last, keepsReplaced: false);
    }

    private static IEnumerable<string> FoldersOf(HarvestOptions options)
    {
        IEnumerable<string> views = options.Rig?.Cameras.Select(camera => camera.Name) ?? [];
        return
        [
            .. With(FramePaths.Frames),
            .. options.Masks ? With(FramePaths.Masks) : [],
            .. CaptureChannels.Of(options).SelectMany(channel => channel.FoldersFor(options)),
        ];

        IEnumerable<string> With(string folder) => [folder, .. views.Select(view => FramePaths.In(folder, view))];
    }

    private void WriteHeader(SessionEnd? end, int frames)
    {
        store.WriteText(SessionDirectory.Header, SessionJson.Text(RecordOf(end, frames)));
        store.Sync();
    }

    private SessionRecord RecordOf(SessionEnd? end, int frames) => new(origin, start, end, frames, before.KeepsManifest);
}
