using System.Text;
using System.Text.Json.Nodes;
using Harvester.Exports.Formats;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.WebDataset;

[Collection(SimulatedSession.Collection)]
public sealed class WebDatasetWriterTests(SimulatedSession simulated) : ExportTests
{
    private const int Block = 512;

    [Fact]
    public void Archive_has_image_label_and_mask_of_a_frame_side_by_side()
    {
        Folder.Export("webdataset", simulated.Open());

        (string Name, byte[] Content)[] entries = [.. Entries(File.ReadAllBytes(Folder.PathOf("out/train-000000.tar")))];
        string[] labels = File.ReadAllLines(Path.Combine(simulated.Folder, "labels.jsonl"));
        Assert.Equal(3 * SimulatedSession.Frames, entries.Length);
        for (int frame = 0; frame < SimulatedSession.Frames; frame++)
        {
            Assert.Equal(
                [$"{frame:D8}.png", $"{frame:D8}.json", $"{frame:D8}.mask.png"],
                entries.Skip(3 * frame).Take(3).Select(entry => entry.Name)
            );
            Assert.Equal(File.ReadAllBytes(Path.Combine(simulated.Folder, $"frames/{frame:D8}.png")), entries[3 * frame].Content);
            Assert.True(JsonNode.DeepEquals(JsonNode.Parse(labels[frame]), JsonNode.Parse(entries[(3 * frame) + 1].Content)));
        }
    }

    [Fact]
    public void Archives_of_a_split_are_numbered_without_gaps()
    {
        // Names of parts are the split and the thousand that the frames are among: val has none among the first and the third.
        IDatasetWriter writer = DatasetFormats.Find("webdataset")!.CreateWriter(new ExportOptions());

        Assert.Equal(
            ["train-000000.tar", "train-000001.tar", "val-000000.tar", "val-000001.tar"],
            writer
                .Aggregates(
                    new Dictionary<string, int>
                    {
                        ["train-000000"] = 1,
                        ["train-000002"] = 1,
                        ["val-000001"] = 1,
                        ["val-000003"] = 1,
                    }
                )
                .Select(file => file.Path)
        );
    }

    /// <summary>
    /// Reads ustar as POSIX 1003.1 lays it out: name at 0, size in octal at 124, checksum at 148, type at 156, magic at 257.
    /// </summary>
    private static IEnumerable<(string Name, byte[] Content)> Entries(byte[] archive)
    {
        Assert.Equal(0, archive.Length % Block);
        int at = 0;
        while (archive[at] != 0)
        {
            byte[] header = archive[at..(at + Block)];
            Assert.Equal("ustar", Encoding.ASCII.GetString(header, 257, 5));
            Assert.Equal((byte)'0', header[156]);
            Assert.Equal(0, Octal(header, 136, 12));
            int sum = header.Select((value, i) => i is >= 148 and < 156 ? (int)' ' : value).Sum();
            Assert.Equal(sum, Octal(header, 148, 8));
            int size = Octal(header, 124, 12);
            yield return (Encoding.ASCII.GetString(header, 0, 100).TrimEnd('\0'), archive[(at + Block)..(at + Block + size)]);
            at += Block + ((size + Block - 1) / Block * Block);
        }

        Assert.Equal(2 * Block, archive.Length - at);
        Assert.All(archive[at..], value => Assert.Equal(0, value));
    }

    private static int Octal(byte[] header, int at, int length) =>
        Convert.ToInt32(Encoding.ASCII.GetString(header, at, length).Trim('\0', ' '), 8);
}
