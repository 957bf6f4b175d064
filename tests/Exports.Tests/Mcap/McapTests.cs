using Google.Protobuf;
using Google.Protobuf.Reflection;
using Harvester.Exports.Formats.Mcap;
using Harvester.Exports.Validation;
using Harvester.Geometry.Lanes;

namespace Harvester.Exports.Tests.Mcap;

public sealed class McapTests : ExportTests
{
    private const string File = "out/train/0000.mcap";

    [Fact]
    public void Every_message_has_the_time_of_its_frame()
    {
        Folder.Export("mcap", Session.Open());

        (int Channel, uint Sequence, ulong Time, byte[] Content)[] messages = [.. McapRecords.Messages(Content())];
        Assert.Equal([0u, 1u, 2u], messages.Where(message => message.Channel == McapChannel.Image.Id).Select(message => message.Sequence));
        Assert.All(messages.GroupBy(message => message.Sequence), frame => Assert.Single(frame.Select(message => message.Time).Distinct()));
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void Image_is_that_of_the_session()
    {
        Folder.Export("mcap", Session.Open());

        byte[] message = McapRecords.Messages(Content()).First(message => message.Channel == McapChannel.Image.Id).Content;
        byte[] picture = System.IO.File.ReadAllBytes(Session.PathOf("frames/00000000.png"));
        Assert.True(message.AsSpan().IndexOf(picture) > 0);
    }

    [Fact]
    public void Schemas_describe_every_message_that_they_use()
    {
        foreach (string name in MessageSchemas.Names)
        {
            FileDescriptorSet set = FileDescriptorSet.Parser.ParseFrom(MessageSchemas.DescriptorsOf(name));

            // Builds the descriptors, which fails if a type or an import is missing or comes too late.
            IReadOnlyList<FileDescriptor> files = FileDescriptor.BuildFromByteStrings(set.File.Select(file => file.ToByteString()));
            Assert.Contains(files.SelectMany(file => file.MessageTypes), message => message.FullName == name);
        }
    }

    [Fact]
    public void Indicators_are_the_fields_of_their_message_in_order()
    {
        string[] fields = [.. Gtaharvest.LaneIndicators.Descriptor.Fields.InFieldNumberOrder().Select(field => field.Name)];

        Assert.Equal(["timestamp", .. IndicatorTable.All.Select(indicator => indicator.Name), "speed"], fields);
    }

    [Theory]
    [InlineData(0.3)]
    [InlineData(0.6)]
    [InlineData(0.999)]
    public void Flipped_bit_is_found(double place)
    {
        Folder.Export("mcap", Session.Open());
        byte[] content = Content();
        content[(int)(place * content.Length)] ^= 1;
        System.IO.File.WriteAllBytes(Folder.PathOf(File), content);

        Assert.Contains(
            DatasetValidator.Validate(Folder.PathOf("out")).Problems,
            problem =>
                problem.ToString().Contains("0000.mcap", StringComparison.Ordinal)
                && !problem.ToString().Contains("manifest", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void File_that_is_cut_off_is_found()
    {
        Folder.Export("mcap", Session.Open());
        System.IO.File.WriteAllBytes(Folder.PathOf(File), Content()[..^100]);

        Assert.Contains(
            DatasetValidator.Validate(Folder.PathOf("out")).Problems,
            problem => problem.ToString().Contains("cut off", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Image_that_was_damaged_before_the_export_is_found()
    {
        System.IO.File.WriteAllText(Session.PathOf("frames/00000001.png"), "no image");
        Folder.Export("mcap", Session.Open());

        Assert.Contains(
            "train/0000.mcap: image 2: it is not a PNG, BMP or JPEG file, or is cut off.",
            DatasetValidator.Validate(Folder.PathOf("out")).Problems.Select(problem => problem.ToString())
        );
    }

    private byte[] Content() => System.IO.File.ReadAllBytes(Folder.PathOf(File));
}
