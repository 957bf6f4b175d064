using System.Diagnostics;
using System.Runtime.InteropServices;
using System.Text.Json.Nodes;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sharding;
using Harvester.Exports.Assembly;
using Harvester.Exports.Validation;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Video;

[Trait("Category", "Heavy")]
[Collection(SimulatedSession.Collection)]
public sealed class VideoTests(SimulatedSession simulated) : ExportTests
{
    private const string Sequence = "out/train/sequence-0000";

    [FfmpegFact]
    public void Lossless_video_has_every_bit_of_images_and_masks()
    {
        Folder.Export("video-lossless", simulated.Open());

        byte[] frames = Decode($"{Sequence}/frames.mkv", "rgb24");
        byte[] masks = Decode($"{Sequence}/masks.mkv", "gray16le");
        JsonNode[] labels = [.. Folder.Lines($"{Sequence}/labels.jsonl").Select(line => JsonNode.Parse(line)!)];
        Assert.Equal(SimulatedSession.Frames, labels.Length);
        int pixels = 200 * 150;
        Assert.Equal(labels.Length * pixels * 3, frames.Length);
        Assert.Equal(labels.Length * pixels * 2, masks.Length);
        for (int k = 0; k < labels.Length; k++)
        {
            byte[] image = PictureReader.Read(Path.Combine(simulated.Folder, (string)labels[k]["image"]!)).Bytes;
            Assert.True(frames.AsSpan(k * pixels * 3, pixels * 3).SequenceEqual(image), $"frame {k}");
            ushort[] mask = PngDecoder.ReadInstanceMap(Path.Combine(simulated.Folder, (string)labels[k]["mask"]!)).Ids;
            Assert.True(MemoryMarshal.Cast<byte, ushort>(masks.AsSpan(k * pixels * 2, pixels * 2)).SequenceEqual(mask), $"mask {k}");
        }

        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [FfmpegFact]
    public void Frame_k_of_a_compressed_video_shows_the_image_of_label_k()
    {
        Folder.Export("video", simulated.Open());

        byte[] frames = Decode($"{Sequence}/frames.mp4", "rgb24");
        JsonNode[] labels = [.. Folder.Lines($"{Sequence}/labels.jsonl").Select(line => JsonNode.Parse(line)!)];
        int bytes = 200 * 150 * 3;
        Assert.Equal(labels.Length * bytes, frames.Length);
        byte[][] images = [.. labels.Select(label => PictureReader.Read(Path.Combine(simulated.Folder, (string)label["image"]!)).Bytes)];
        for (int k = 0; k < labels.Length; k++)
        {
            double[] differences = [.. images.Select(image => Difference(frames.AsSpan(k * bytes, bytes), image))];
            Assert.Equal(differences.Min(), differences[k]);
        }
    }

    [FfmpegFact]
    public void Shards_and_repetitions_give_the_same_bytes()
    {
        Folder.Export("video", simulated.Open(), to: "single");
        Folder.Export("video", simulated.Open(), to: "a", shard: new Shard(1, 2));
        Folder.Export("video", simulated.Open(), to: "b", shard: new Shard(2, 2));
        DatasetMerger.Merge([Folder.PathOf("a"), Folder.PathOf("b")], Folder.PathOf("merged"), new MergeOptions(ImageTransfer.Copy));

        Assert.Equal(Folder.Contents("single"), Folder.Contents("merged"));
    }

    [FfmpegFact]
    public void Lost_video_and_damaged_label_are_found()
    {
        Folder.Export("video", simulated.Open());
        File.Delete(Folder.PathOf($"{Sequence}/frames.mp4"));
        string labels = Folder.PathOf($"{Sequence}/labels.jsonl");
        File.WriteAllText(labels, File.ReadAllText(labels).Replace("\"camera\":", "\"lens\":", StringComparison.Ordinal));

        string[] problems = [.. DatasetValidator.Validate(Folder.PathOf("out")).Problems.Select(problem => problem.ToString())];

        Assert.Contains(problems, problem => problem.StartsWith("train/sequence-0000/frames.mp4: it is missing", StringComparison.Ordinal));
        Assert.Contains(problems, problem => problem.StartsWith("train/sequence-0000/labels.jsonl, line 1: ", StringComparison.Ordinal));
    }

    [FfmpegFact]
    public void Session_with_some_masks_is_refused()
    {
        Session.Info["options"] = new JsonObject { ["rateHz"] = 2 };
        Session.Lines[1]["mask"] = null;
        Session.Lines[1]["pixelMap"] = null;

        SessionReader session = Session.Open();
        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() => Folder.Export("video", session));

        Assert.Contains("has masks for 2 of 3 frames", refused.Message, StringComparison.Ordinal);
    }

    private byte[] Decode(string file, string pixels)
    {
        var start = new ProcessStartInfo("ffmpeg") { RedirectStandardOutput = true, RedirectStandardInput = true };
        foreach (string word in (string[])["-loglevel", "error", "-i", Folder.PathOf(file), "-f", "rawvideo", "-pix_fmt", pixels, "pipe:1"])
        {
            start.ArgumentList.Add(word);
        }

        using Process process = Process.Start(start)!;
        process.StandardInput.Close();
        using var bytes = new MemoryStream();
        process.StandardOutput.BaseStream.CopyTo(bytes);
        process.WaitForExit();
        Assert.Equal(0, process.ExitCode);
        return bytes.ToArray();
    }

    private static double Difference(ReadOnlySpan<byte> one, ReadOnlySpan<byte> other)
    {
        double sum = 0;
        for (int i = 0; i < one.Length; i++)
        {
            sum += Math.Abs(one[i] - other[i]);
        }

        return sum / one.Length;
    }
}
