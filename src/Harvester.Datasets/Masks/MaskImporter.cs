using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Masks;

/// <summary>
/// Takes the instance maps of another tool, made of stencil or depth buffers for example, into a session: its masks, visible boxes and
/// occlusion are theirs from then on. Nothing of the session changes before all of them were found good.
/// </summary>
public static class MaskImporter
{
    /// <summary>Imports a map for every frame of a session.</summary>
    /// <param name="session">The session.</param>
    /// <param name="folder">Where the maps are: 16-bit grey PNG files named by frame number.</param>
    /// <param name="numbers">What the numbers in them mean.</param>
    /// <param name="cancellation">Stops between two frames; the session is as it was.</param>
    /// <exception cref="DatasetFormatException">A label or a map is at fault; the message names it.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public static MaskImport Import(SessionReader session, string folder, MaskNumbers numbers, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(session);
        var maps = new ExternalMaps(folder);
        string staged = AtomicFile.TemporaryFor(session.PathOf(FramePaths.Masks));
        var encoder = new PngEncoder();
        var done = new MaskImport(0, 0, 0);
        Directory.CreateDirectory(staged);
        try
        {
            AtomicFile.Write(session.PathOf(SessionReader.LabelsFile), file =>
            {
                using (var lines = new StreamWriter(file, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" })
                {
                    foreach ((string line, FrameLabel label) in session.ReadTexts().Zip(session.ReadLabels()))
                    {
                        cancellation.ThrowIfCancellationRequested();
                        var size = new ImageSize(label.Camera.Width, label.Camera.Height);
                        var frame = new ImportedFrame(label, maps.Read(label.Frame, size), numbers);
                        string mask = Path.Combine(staged, Path.GetFileName(FramePaths.Mask(label.Frame)));
                        AtomicFile.Write(mask, stream => encoder.Write(frame.Map, stream));
                        lines.WriteLine(frame.Rewrite(line));
                        done = new MaskImport(done.Frames + 1, done.Objects + label.Objects.Count, done.Seen + frame.Seen);
                    }
                }

                MoveAll(staged, session.PathOf(FramePaths.Masks));
            });
        }
        finally
        {
            Directory.Delete(staged, recursive: true);
        }

        return done;
    }

    private static void MoveAll(string from, string to)
    {
        Directory.CreateDirectory(to);
        foreach (string file in Directory.EnumerateFiles(from))
        {
            File.Move(file, Path.Combine(to, Path.GetFileName(file)), overwrite: true);
        }
    }
}
