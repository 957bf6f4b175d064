using System.Formats.Tar;
using System.Text;
using System.Text.Json.Nodes;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.WebDataset;

/// <summary>
/// Writes WebDataset: tar files (ustar) in which the files of a sample are consecutive and share their name up to the first point. A
/// frame's entries are staged as bytes of the archive; an archive is the concatenation of those of its frames. See
/// docs/exports/webdataset.md.
/// </summary>
internal sealed class WebDatasetWriter : IDatasetWriter
{
    private const int FramesPerArchive = 1000;

    /// <summary>Two empty blocks end an archive.</summary>
    private const int EndLength = 2 * 512;

    /// <summary>Pattern of the archives of a split. All digits count: a split may be named as another with a number appended.</summary>
    public static string ArchivesOf(string split) => split + "-[0-9][0-9][0-9][0-9][0-9][0-9].tar";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string archive = $"{frame.Split}-{frame.Index / FramesPerArchive:D6}";
        output.StagedPart(
            archive,
            frame.Name + ".tar",
            stream =>
            {
                using var entries = new MemoryStream();
                using (var tar = new TarWriter(entries, TarEntryFormat.Ustar, leaveOpen: true))
                {
                    Add(tar, frame.Name + frame.ImageExtension, output.ImageBytes(frame));
                    Add(tar, frame.Name + ".json", Encoding.UTF8.GetBytes(LabelOf(frame)));
                    if (frame.MaskPath is { } mask)
                    {
                        Add(tar, frame.Name + ".mask.png", InputFile.ReadAllBytes(mask, InputFile.MaxPictureBytes));
                    }

                    if (frame.ClassMapPath is { } classes)
                    {
                        Add(tar, frame.Name + ".classes.png", InputFile.ReadAllBytes(classes, InputFile.MaxPictureBytes));
                    }
                }

                stream.Write(entries.GetBuffer(), 0, (int)entries.Length - EndLength);
            }
        );
        return new WrittenObjects(frame.Objects.Count);
    }

    /// <summary>The archives of a split are numbered without gaps, because patterns such as {000000..000009} require it.</summary>
    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts
            .Keys.GroupBy(SplitOf)
            .SelectMany(split =>
                split.Select(
                    (part, number) =>
                        new AggregateFile(
                            $"{split.Key}-{number:D6}.tar",
                            [AggregateSection.Files(part), AggregateSection.Literal(new string('\0', EndLength))]
                        )
                )
            );

    private static string SplitOf(string archive) =>
        archive.LastIndexOf('-') is var end and > 0
            ? archive[..end]
            : throw new DatasetFormatException(
                $"A journal of the export has '{archive}', which is not an archive. Delete the folder and export again."
            );

    /// <summary>The line of the session with all decimals, without the objects that are not exported.</summary>
    private static string LabelOf(ExportFrame frame)
    {
        JsonNode label = JsonNode.Parse(frame.LabelText)!;
        HashSet<int> kept = [.. frame.Objects.Select(item => item.Label.Id)];
        label["objects"]!.AsArray().RemoveAll(item => !kept.Contains(item!["id"]!.GetValue<int>()));
        return label.ToJsonString();
    }

    private static void Add(TarWriter tar, string name, byte[] content) =>
        tar.WriteEntry(
            new UstarTarEntry(TarEntryType.RegularFile, name)
            {
                ModificationTime = DateTimeOffset.UnixEpoch,
                Mode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead,
                DataStream = new MemoryStream(content),
            }
        );
}
