using System.Text;
using Harvester.Exports.Assembly;
using Harvester.Exports.Validation;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Flow;

/// <summary>Exports of optical flow have the numbers of the session's forward maps, pixel by pixel, and damage to them is found.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class FlowExportTests(SimulatedSession simulated) : ExportTests
{
    private const int Valid = 1;
    private const int Moved = 2;
    private const int CoveredOrOutside = 4 + 8;

    [Fact]
    public void Kitti_has_the_flow_of_all_and_of_the_visible_pixels()
    {
        ExportResult result = Folder.Export("kitti-flow", simulated.OpenWithFlow());
        AssertValid();
        FrameLabel label = LastWithFlow();
        (ushort[] vectors, ushort[] flags) = MapsOf(label);
        ushort[] all = PngDecoder.ReadDeepColour(Out($"training/flow_occ/{label.Frame:D6}_10.png"));
        ushort[] visible = PngDecoder.ReadDeepColour(Out($"training/flow_noc/{label.Frame:D6}_10.png"));
        ushort[] moved = PngDecoder.ReadLabelMap(Out($"training/obj_map/{label.Frame:D6}_10.png")).Ids;

        Assert.Equal(vectors, all);
        for (int at = 0; at < flags.Length; at++)
        {
            bool isSeen = (flags[at] & (Valid | CoveredOrOutside)) == Valid;
            Assert.Equal(isSeen ? vectors[(3 * at)..((3 * at) + 3)] : [0, 0, 0], visible[(3 * at)..((3 * at) + 3)]);
            Assert.Equal((flags[at] & Moved) / Moved, moved[at]);
        }

        Assert.Equal(SimulatedSession.Frames, result.Frames + result.FramesLeftOut);
        Assert.True(result.FramesLeftOut > 0);
    }

    [Theory]
    [InlineData("kitti-flow", "training/image_2/{0}_10.png", "training/image_2/{0}_11.png")]
    [InlineData("middlebury-flow", "other-data/{0}/frame10.png", "other-data/{0}/frame11.png")]
    public void Images_of_a_pair_are_those_of_consecutive_frames(string format, string first, string second)
    {
        Folder.Export(format, simulated.OpenWithFlow());
        FrameLabel label = LastWithFlow();
        string name = $"{label.Frame:D6}";
        int from = label.Channels.Get<FlowLabel>()!.From;

        Assert.Equal(ImageOf(from), File.ReadAllBytes(Out(first.Replace("{0}", name, StringComparison.Ordinal))));
        Assert.Equal(ImageOf(label.Frame), File.ReadAllBytes(Out(second.Replace("{0}", name, StringComparison.Ordinal))));
        Assert.NotEqual(ImageOf(from), ImageOf(label.Frame));
    }

    [Fact]
    public void Middlebury_has_the_flow_in_pixels()
    {
        Folder.Export("middlebury-flow", simulated.OpenWithFlow());
        AssertValid();
        FrameLabel label = LastWithFlow();
        (ushort[] vectors, ushort[] flags) = MapsOf(label);
        using var file = new BinaryReader(File.OpenRead(Out($"other-gt-flow/{label.Frame:D6}/flow10.flo")));

        Assert.Equal("PIEH", Encoding.ASCII.GetString(file.ReadBytes(4)));
        Assert.Equal((label.Camera.Width, label.Camera.Height), (file.ReadInt32(), file.ReadInt32()));
        for (int at = 0; at < flags.Length; at++)
        {
            (float right, float down) = (file.ReadSingle(), file.ReadSingle());
            if ((flags[at] & Valid) != 0)
            {
                Assert.Equal(((vectors[3 * at] - 32768) / 64f, (vectors[(3 * at) + 1] - 32768) / 64f), (right, down));
            }
            else
            {
                Assert.True(right > 1e9f && down > 1e9f);
            }
        }

        Assert.Equal(file.BaseStream.Length, file.BaseStream.Position);
    }

    [Fact]
    public void Session_without_flow_is_refused()
    {
        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() => Folder.Export("kitti-flow", simulated.Open()));

        Assert.Equal(
            "No frame has a flow from a frame before, which kitti-flow needs. Harvest with --flow, or choose another format.",
            refused.Message
        );
    }

    [Fact]
    public void Damaged_kitti_flow_is_found()
    {
        Folder.Export("kitti-flow", simulated.OpenWithFlow());
        string name = $"{LastWithFlow().Frame:D6}";
        string visible = $"training/flow_noc/{name}_10.png";
        ushort[] vectors = PngDecoder.ReadDeepColour(Out(visible));
        vectors[Enumerable.Range(0, vectors.Length / 3).First(at => vectors[(3 * at) + 2] == 1) * 3]++;
        Write(visible, vectors);
        File.Delete(Out($"training/obj_map/{name}_10.png"));

        string[] problems = Problems();

        Assert.Contains($"{visible}: it has a flow that flow_occ has not.", problems);
        Assert.Contains($"training/obj_map/{name}_10.png: it is missing, but its images exist.", problems);
    }

    [Theory]
    [InlineData(0, "it does not begin with the number of a file of flow, 202021.25.")]
    [InlineData(4, "its size is not that of its images.")]
    [InlineData(15, "pixel 0 is neither a flow nor unknown.")]
    public void Damaged_middlebury_flow_is_found(int at, string problem)
    {
        Folder.Export("middlebury-flow", simulated.OpenWithFlow());
        string file = $"other-gt-flow/{LastWithFlow().Frame:D6}/flow10.flo";
        byte[] bytes = File.ReadAllBytes(Out(file));

        // Of the first number of the first pixel, the sign and the exponent: it becomes not a number.
        bytes[at] = 0xFF;
        bytes[at - (at > 4 ? 1 : 0)] = 0xFF;
        File.WriteAllBytes(Out(file), bytes);

        Assert.Contains($"{file}: {problem}", Problems());
    }

    private string Out(string name) => Folder.PathOf($"out/{name}");

    private byte[] ImageOf(int frame) =>
        File.ReadAllBytes(Path.Combine(simulated.OpenWithFlow().Folder, "frames", FormattableString.Invariant($"{frame:D8}.png")));

    private FrameLabel LastWithFlow() => simulated.OpenWithFlow().ReadLabels().Last(label => label.Channels.Get<FlowLabel>() is not null);

    private (ushort[] Vectors, ushort[] Flags) MapsOf(FrameLabel label)
    {
        FlowFiles maps = label.Channels.Get<FlowLabel>()!.Maps;
        string folder = simulated.OpenWithFlow().Folder;
        return (
            PngDecoder.ReadDeepColour(Path.Combine(folder, maps.Forward)),
            PngDecoder.ReadLabelMap(Path.Combine(folder, maps.ForwardFlags)).Ids
        );
    }

    private void Write(string name, ushort[] vectors)
    {
        CameraLabel camera = LastWithFlow().Camera;
        using FileStream stream = File.Create(Out(name));
        new PngEncoder().WriteDeepColour(
            new ImageSize(camera.Width, camera.Height),
            (row, line) =>
            {
                for (int at = 0; at < line.Length; at += 2)
                {
                    ushort number = vectors[(row * camera.Width * 3) + (at / 2)];
                    (line[at], line[at + 1]) = ((byte)(number >> 8), (byte)number);
                }
            },
            stream
        );
    }

    private string[] Problems() => [.. DatasetValidator.Validate(Folder.PathOf("out")).Problems.Select(problem => problem.ToString())];

    private void AssertValid() => Assert.Empty(Problems());
}
