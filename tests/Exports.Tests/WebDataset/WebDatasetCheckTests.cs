using System.Formats.Tar;
using System.Text;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.WebDataset;

public sealed class WebDatasetCheckTests(SimulatedSession simulated) : CheckTests(simulated, "webdataset")
{
    private const string Archive = "train-000000.tar";

    [Fact]
    public void Truncated_archive_is_found()
    {
        Export();
        byte[] archive = Bytes();
        File.WriteAllBytes(Folder.PathOf("out/" + Archive), archive[..^1024]);
        AssertFound($"{Archive}: it is cut off: two empty blocks must end it.");

        // A header and the first of the blocks that it announces.
        File.WriteAllBytes(Folder.PathOf("out/" + Archive), archive[..1024]);
        AssertFound($"{Archive}: it is damaged: an entry cannot be read.");
        File.WriteAllBytes(Folder.PathOf("out/" + Archive), archive[..^5]);
        AssertFound($"{Archive}: it is cut off: it does not consist of whole blocks.");
    }

    [Fact]
    public void A_header_that_was_changed_is_found()
    {
        Export();
        byte[] archive = Bytes();
        // The second digit of the size: the checksum no longer matches the header.
        archive[126]++;
        File.WriteAllBytes(Folder.PathOf("out/" + Archive), archive);
        AssertFound($"{Archive}: it is damaged: an entry cannot be read.");
    }

    [Fact]
    public void A_sample_without_its_label_is_found()
    {
        Rewrite(entry => entry.Name == "00000002.json" ? null : entry);
        AssertFound($"{Archive}: sample 00000002: its image or its label is missing.");
    }

    [Fact]
    public void Unreadable_label_is_found()
    {
        Rewrite(entry => entry.Name == "00000002.json" ? (entry.Name, Encoding.UTF8.GetBytes("{\"frame\":2}")) : entry);
        AssertFound($"{Archive}: sample 00000002: json: gameFrame is missing.");
    }

    [Fact]
    public void Parts_that_contradict_the_label_are_found()
    {
        Rewrite(entry =>
            entry.Name switch
            {
                "00000001.png" => (entry.Name, TestImages.Png(20, 15)),
                "00000002.png" => (entry.Name, entry.Content[..^20]),
                "00000003.mask.png" => (entry.Name, TestImages.Png(200, 150)),
                "00000004.mask.png" => ("00000004.depth.png", entry.Content),
                _ => entry,
            }
        );
        AssertFound($"{Archive}: sample 00000001: image: it is 20 x 15, but its label says 200 x 150.");
        AssertFound($"{Archive}: sample 00000002: image: it is cut off");
        AssertFound($"{Archive}: sample 00000003: mask.png: it has 24 bits per pixel instead of 16.");
        AssertFound($"{Archive}: sample 00000004: depth.png: it is not a part of a sample.");
    }

    [Fact]
    public void Duplicate_sample_is_found()
    {
        Rewrite(entry =>
            entry.Name.StartsWith("00000003", StringComparison.Ordinal) ? (entry.Name.Replace('3', '1'), entry.Content) : entry
        );
        AssertFound($"{Archive}: sample 00000001: it occurs twice, here or in another archive.");
    }

    [Fact]
    public void Archives_missing_or_without_a_split_are_found()
    {
        Export();
        File.Move(Folder.PathOf("out/" + Archive), Folder.PathOf("out/test-000000.tar"));
        AssertFound("test-000000.tar: its name is not that of a split of the export with a number.");
        AssertFound("export.json: it counts 7 frames in train, but the dataset has 0.");
    }

    private byte[] Bytes() => File.ReadAllBytes(Folder.PathOf("out/" + Archive));

    /// <summary>Rewrites the archive with other entries.</summary>
    private void Rewrite(Func<(string Name, byte[] Content), (string Name, byte[] Content)?> change)
    {
        Export();
        using var source = new TarReader(new MemoryStream(Bytes()));
        using var target = new TarWriter(File.Create(Folder.PathOf("out/" + Archive)), TarEntryFormat.Ustar);
        while (source.GetNextEntry() is { } entry)
        {
            using var content = new MemoryStream();
            entry.DataStream!.CopyTo(content);
            if (change((entry.Name, content.ToArray())) is { } changed)
            {
                target.WriteEntry(
                    new UstarTarEntry(TarEntryType.RegularFile, changed.Name) { DataStream = new MemoryStream(changed.Content) }
                );
            }
        }
    }
}
