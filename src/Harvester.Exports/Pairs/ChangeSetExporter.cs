using System.Globalization;
using CsvHelper;
using Harvester.Datasets.Files;
using Harvester.Exports.Formats.Csv;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Pairs;

/// <summary>
/// Exports a set of counterfactuals: the images of the same frame of all runs form a group, and tables say from which frame on a run
/// differs from the base. Every file is written whole; the tables, which name all others, come last.
/// </summary>
/// <param name="source">The folder of the set.</param>
/// <param name="transfer">Whether images are linked or copied.</param>
/// <param name="cancellation">Stops between two frames.</param>
public sealed class ChangeSetExporter(string source, ImageTransfer transfer, CancellationToken cancellation = default)
{
    private readonly ChangeSet _set = ChangeSet.Read(source);

    /// <summary>Number of frames of the base.</summary>
    public int Frames => Session(ChangeSet.Base).CountLines();

    /// <summary>Writes the export.</summary>
    /// <param name="folder">The folder, which is empty except for its mark.</param>
    /// <param name="report">Receives the number of frames after each frame.</param>
    /// <exception cref="DatasetFormatException">A label or an image is invalid or missing.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public PairExport Run(string folder, Action<int> report)
    {
        ArgumentNullException.ThrowIfNull(report);
        SessionReader original = Session(ChangeSet.Base);
        List<ChangedFrames> runs = [.. _set.Changes.Select(run => new ChangedFrames(run, Session(run.Folder)))];
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        int groups = 0;
        int images = 0;
        try
        {
            using CsvWriter index = PairTables.Begin(text);
            PairTables.Write(index, ["group", "run", "image", "time_seconds", "image_differs", "label_differs"]);
            foreach (LabelLine line in original.ReadGoodLines())
            {
                cancellation.ThrowIfCancellationRequested();
                string group = PairGroup.Of(line).Key;
                string place = Place(folder, group, ChangeSet.Base, original, line);
                PairTables.Write(index, [group, ChangeSet.Base, place, TimeOf(line), "0", "0"]);
                images++;
                foreach (ChangedFrames run in runs)
                {
                    if (run.Compare(original, line) is { } difference)
                    {
                        string changed = Place(folder, group, run.Run.Folder, run.Session, difference.Line);
                        PairTables.Write(
                            index,
                            [group, run.Run.Folder, changed, TimeOf(difference.Line), Flag(difference.Image), Flag(difference.Label)]
                        );
                        images++;
                    }
                }

                report(++groups);
            }
        }
        finally
        {
            runs.ForEach(run => run.Dispose());
        }

        AtomicFile.Write(Path.Combine(folder, PairTables.Changes), ChangesOf(runs), isDurable: false);
        AtomicFile.Write(Path.Combine(folder, PairTables.Index), text.ToString(), isDurable: false);
        return new PairExport(groups, images, (groups * (runs.Count + 1)) - images);
    }

    private static string ChangesOf(List<ChangedFrames> runs)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        using (CsvWriter changes = PairTables.Begin(text))
        {
            PairTables.Write(changes, ["run", "change", "first_label_that_differs", "first_image_that_differs"]);
            foreach (ChangedFrames run in runs)
            {
                PairTables.Write(changes, [run.Run.Folder, CsvText.Of(run.Run.Change), NumberOf(run.FirstLabel), NumberOf(run.FirstImage)]);
            }
        }

        return text.ToString();
    }

    private string Place(string folder, string group, string run, SessionReader session, LabelLine line)
    {
        string name = $"{PairExporter.Images}/{group}/{run}{Path.GetExtension(line.Label!.Image)}";
        string target = InnerPath.Of(folder, name);
        Directory.CreateDirectory(Path.GetDirectoryName(target)!);
        FileTransfer.Place(target, session.PathOf(line.Label.Image), transfer);
        return name;
    }

    private SessionReader Session(string name) => new(Path.Combine(source, name), cancellation);

    private static string TimeOf(LabelLine line) => line.Label!.TimeSeconds.ToString("0.###", CultureInfo.InvariantCulture);

    private static string Flag(bool isSet) => isSet ? "1" : "0";

    private static string NumberOf(int? frame) => frame?.ToString(CultureInfo.InvariantCulture) ?? "";
}
