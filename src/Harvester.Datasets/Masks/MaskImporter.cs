using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;

namespace Harvester.Datasets.Masks;

/// <summary>
/// Imports the instance maps of another tool, made from stencil or depth buffers for example, as the masks of a session, and recomputes
/// visible boxes and occlusion from them. The session with the new masks is written beside the old one and replaces it in one step.
/// </summary>
public static class MaskImporter
{
    private static readonly EnumerationOptions OwnEntries = new()
    {
        RecurseSubdirectories = true,
        AttributesToSkip = FileAttributes.ReparsePoint,
    };

    /// <summary>Imports a map for every frame of a session.</summary>
    /// <param name="session">The session.</param>
    /// <param name="folder">Folder of the maps: 16-bit greyscale PNG files named by frame number.</param>
    /// <param name="numbers">The meaning of their values.</param>
    /// <param name="finish">Updates what else depends on the masks in the new session, such as a report; null for nothing.</param>
    /// <param name="sync">When to wait for the disk.</param>
    /// <param name="cancellation">Stops between two frames; the session is unchanged then.</param>
    /// <exception cref="DatasetFormatException">A label or a map is invalid; the message names it.</exception>
    /// <exception cref="IOException">A file cannot be read or written; the session is unchanged then.</exception>
    public static MaskImport Import(
        SessionReader session,
        string folder,
        MaskNumbers numbers,
        Action<SessionReader>? finish = null,
        SyncMode sync = SyncMode.Batch,
        CancellationToken cancellation = default
    )
    {
        ArgumentNullException.ThrowIfNull(session);
        var maps = new ExternalMaps(folder);
        using FolderReplacement replacement = FolderReplacement.Begin(session.Folder);
        string made = replacement.Folder;
        Directory.CreateDirectory(Path.Combine(made, FramePaths.Masks));
        var encoder = new PngEncoder();
        bool isDurable = sync != SyncMode.Never;
        var done = new MaskImport(0, 0, 0);
        AtomicLines.Write(
            Path.Combine(made, SessionReader.LabelsFile),
            isDurable,
            lines =>
                AtomicLines.Write(
                    Path.Combine(made, Manifest.FileName),
                    isDurable,
                    manifest =>
                    {
                        using var digests = new CarriedDigests(session);
                        foreach ((string line, FrameLabel label) in session.ReadTexts().Zip(session.ReadLabels()))
                        {
                            cancellation.ThrowIfCancellationRequested();
                            var size = new ImageSize(label.Camera.Width, label.Camera.Height);
                            var frame = new ImportedFrame(label, maps.Read(label.Frame, size), numbers);
                            FileDigest digest = default;
                            string mask = Path.Combine(made, FramePaths.Mask(label.Frame, label.View));
                            Directory.CreateDirectory(Path.GetDirectoryName(mask)!);
                            AtomicFile.Write(
                                mask,
                                stream => digest = DigestStream.Write(stream, content => encoder.Write(frame.Map, content)),
                                isDurable
                            );
                            string rewritten = frame.Rewrite(line);
                            lines.WriteLine(rewritten);
                            manifest.WriteLine(
                                Manifest.FrameLine(label.Frame, FileDigest.Of(rewritten), FilesOf(session, label, digest, digests))
                            );
                            done = With(done, label, frame);
                        }

                        foreach (string name in OthersOf(session))
                        {
                            manifest.WriteLine(Manifest.FileLine(name, digests.Of(name)));
                        }
                    }
                )
        );
        FolderCopy.AddMissing(session.Folder, made);
        finish?.Invoke(new SessionReader(made));
        if (isDurable)
        {
            Sync(made);
        }

        return done with
        {
            Leftover = replacement.Complete(),
        };
    }

    private static void Sync(string made)
    {
        var batch = new SyncBatch();
        batch.AddFolder(made);
        foreach (string folder in Directory.EnumerateDirectories(made, "*", OwnEntries))
        {
            batch.AddFolder(folder);
        }

        // What the file system could not link is a copy, which nothing has brought to the disk yet.
        foreach (string file in Directory.EnumerateFiles(made, "*", OwnEntries))
        {
            batch.Add(file);
        }

        batch.Flush();
    }

    private static IEnumerable<KeyValuePair<string, FileDigest>> FilesOf(
        SessionReader session,
        FrameLabel label,
        FileDigest mask,
        CarriedDigests digests
    )
    {
        yield return new(label.Image, digests.Of(label.Frame, label.Image));
        yield return new(FramePaths.Mask(label.Frame, label.View), mask);
        foreach (string file in label.Channels.Files)
        {
            yield return new(file, digests.Of(label.Frame, file));
        }

        if (label.Frame >= 0 && FramePaths.Scene(label.Frame) is var scene && File.Exists(session.PathOf(scene)))
        {
            yield return new(scene, digests.Of(label.Frame, scene));
        }
    }

    private static IEnumerable<string> OthersOf(SessionReader session) =>
        ((string[])[FramePaths.Events, FramePaths.Roads, FramePaths.Faces, ScenarioRecord.FileName, SessionInfo.FileName]).Where(name =>
            File.Exists(session.PathOf(name))
        );

    private static MaskImport With(MaskImport done, FrameLabel label, ImportedFrame frame)
    {
        bool isFirst = done.FirstFrameWithDropped is null && frame.DroppedPixels > 0;
        return done with
        {
            Frames = done.Frames + 1,
            Objects = done.Objects + label.Objects.Count,
            Seen = done.Seen + frame.Seen,
            DroppedPixels = done.DroppedPixels + frame.DroppedPixels,
            FirstFrameWithDropped = isFirst ? label.Frame : done.FirstFrameWithDropped,
            FirstDroppedValues = isFirst ? frame.DroppedValues : done.FirstDroppedValues,
        };
    }
}
