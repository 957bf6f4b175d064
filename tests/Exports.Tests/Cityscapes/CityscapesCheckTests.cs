using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Cityscapes;

public sealed class CityscapesCheckTests(SimulatedSession simulated) : CheckTests(simulated, "cityscapes")
{
    private const string City = "train/session0000/session0000_000000_000001_";
    private const string Instances = "gtFine/" + City + "gtFine_instanceIds.png";
    private const string Labels = "gtFine/" + City + "gtFine_labelIds.png";
    private const string Image = "leftImg8bit/" + City + "leftImg8bit.png";

    [Theory]
    [InlineData(Instances, Instances + ": it is missing, but its image exists.")]
    [InlineData(Labels, Labels + ": it is missing, but its image exists.")]
    [InlineData(Image, Instances + ": its image is missing.")]
    [InlineData(Image, "export.json: it counts 7 frames in train, but the dataset has 6.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);

    [Fact]
    public void Maps_that_disagree_are_found()
    {
        Export();
        InstanceMap map = PngDecoder.ReadInstanceMap(Folder.PathOf("out/" + Instances));
        Assert.Equal(0, map.Ids[0]);
        map.Ids[0] = 26_000;
        Write(Instances, (png, file) => png.Write(map, file));
        AssertFound($"{Instances}: at column 0, row 0, instance 26000 is not of label 0.");
    }

    [Theory]
    // Pedestrians, 24, have instances; signs, 20, do not; 27 and 34 thousand are trucks and no label.
    [InlineData(24)]
    [InlineData(20_001)]
    [InlineData(34_000)]
    public void Ids_without_an_instance_are_found(int number)
    {
        Export();
        InstanceMap map = PngDecoder.ReadInstanceMap(Folder.PathOf("out/" + Instances));
        InstanceMap labels = PngDecoder.ReadLabelMap(Folder.PathOf("out/" + Labels));
        map.Ids[0] = (ushort)number;
        labels.Ids[0] = (ushort)(number < 1000 ? number : number / 1000);
        Write(Instances, (png, file) => png.Write(map, file));
        Write(Labels, (png, file) => png.WriteGrey8(labels, file));
        AssertFound($"{Instances}: {number} is not an instance of an exported label.");
    }

    [Fact]
    public void A_map_of_another_size_or_kind_is_found()
    {
        Export();
        Write(Labels, (png, file) => png.WriteGrey8(new InstanceMap(new ImageSize(20, 15)), file));
        AssertFound($"{Labels}: it is 20 x 15, but its image is 200 x 150.");
        Write(Labels, (png, file) => png.Write(new InstanceMap(new ImageSize(200, 150)), file));
        AssertFound($"{Labels}: it is not an 8-bit grey PNG");
    }

    [Fact]
    public void A_frame_in_two_splits_is_found()
    {
        Export(TwoSplits);
        string image = Directory
            .EnumerateFiles(Folder.PathOf("out/leftImg8bit/train/session0000"))
            .Select(Path.GetFileName)
            .Order()
            .First()!;
        Copy($"leftImg8bit/train/session0000/{image}", $"leftImg8bit/val/session0000/{image}");
        AssertFound($"leftImg8bit/val/session0000/{image}: it is in another split too.");
    }

    private void Write(string name, Action<PngEncoder, Stream> write)
    {
        using FileStream file = File.Create(Folder.PathOf("out/" + name));
        write(new PngEncoder(), file);
    }
}
