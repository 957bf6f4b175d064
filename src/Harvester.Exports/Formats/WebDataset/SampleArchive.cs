using System.Formats.Tar;
using System.Text;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.WebDataset;

/// <summary>An archive of samples, read entry by entry.</summary>
/// <param name="dataset">The dataset.</param>
/// <param name="name">The archive.</param>
/// <param name="split">The split of the archive.</param>
/// <param name="keys">Keys of the samples in all archives read before.</param>
internal sealed class SampleArchive(DatasetContent dataset, string name, string split, HashSet<string> keys)
{
    private const int BlockLength = 512;
    private const int EndLength = 2 * BlockLength;
    private const int MaskBits = 16;
    private const int ClassBits = 8;
    private const int MaxKeyLength = 255;
    private const int MaxSamples = 1_000_000;
    private const long MaxSampleBytes = 512L << 20;
    private const string ImageEnd = "image";

    public IEnumerable<SessionProblem> Problems()
    {
        using FileStream file = InputFile.OpenRead(dataset.PathOf(name));
        if (EndProblem(file) is { } endProblem)
        {
            yield return new SessionProblem(name, null, endProblem);
        }

        if (TarNames.Problem(file) is { } nameProblem)
        {
            yield return new SessionProblem(name, null, nameProblem);
            yield break;
        }

        using var archive = new TarReader(file);
        string key = "";
        long sampleBytes = 0;
        Dictionary<string, byte[]> sample = [];
        string? damage;
        while (TryRead(archive, out string entry, out byte[] content, out damage))
        {
            string entryKey = entry.Split('.')[0];
            if (entryKey != key)
            {
                foreach (SessionProblem problem in SampleProblems(key, sample))
                {
                    yield return problem;
                }

                (key, sample, sampleBytes) = (entryKey, [], 0);
            }

            sampleBytes += content.Length;
            if (key.Length > MaxKeyLength || keys.Count > MaxSamples || sampleBytes > MaxSampleBytes)
            {
                yield return new SessionProblem(
                    name,
                    null,
                    $"the key of a sample has more than {MaxKeyLength} characters, a sample has more than {MaxSampleBytes} bytes, "
                        + $"or there are more than {MaxSamples} samples, the limits."
                );
                yield break;
            }

            string part = entry[Math.Min(entry.Length, key.Length + 1)..];
            if (!sample.TryAdd(part is "png" or "bmp" or "jpg" ? ImageEnd : part, content))
            {
                yield return new SessionProblem(name, null, $"{entry} occurs twice.");
            }
        }

        foreach (SessionProblem problem in SampleProblems(key, sample))
        {
            yield return problem;
        }

        if (damage is not null)
        {
            yield return new SessionProblem(name, null, damage);
        }
    }

    private static string? EndProblem(FileStream file)
    {
        if (file.Length < EndLength || file.Length % BlockLength != 0)
        {
            return "it is cut off: it does not consist of whole blocks.";
        }

        byte[] end = new byte[EndLength];
        file.Seek(-EndLength, SeekOrigin.End);
        file.ReadExactly(end);
        file.Seek(0, SeekOrigin.Begin);
        return end.All(value => value == 0) ? null : "it is cut off: two empty blocks must end it.";
    }

    private static bool TryRead(TarReader archive, out string entryName, out byte[] content, out string? damage)
    {
        (entryName, content, damage) = ("", [], null);
        try
        {
            if (archive.GetNextEntry() is not { } entry)
            {
                return false;
            }

            if (entry.Length > InputFile.MaxPictureBytes)
            {
                damage = $"an entry has {entry.Length} bytes; {InputFile.MaxPictureBytes} is the limit.";
                return false;
            }

            content = new byte[entry.Length];
            entry.DataStream?.ReadExactly(content);
            entryName = entry.Name;
            return true;
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException or FormatException or OverflowException)
        {
            damage = "it is damaged: an entry cannot be read.";
            return false;
        }
    }

    private IEnumerable<SessionProblem> SampleProblems(string key, Dictionary<string, byte[]> sample)
    {
        if (sample.Count == 0)
        {
            return [];
        }

        dataset.Found(split);
        IEnumerable<string> messages = keys.Add(key) ? PartProblems(sample) : ["it occurs twice, here or in another archive."];
        return messages.Select(message => new SessionProblem(name, null, $"sample {key}: {message}"));
    }

    private static IEnumerable<string> PartProblems(Dictionary<string, byte[]> sample)
    {
        if (!sample.TryGetValue("json", out byte[]? json) || !sample.ContainsKey(ImageEnd))
        {
            yield return "its image or its label is missing.";
            yield break;
        }

        (FrameLabel? label, string? problem) = ReadLabel(json);
        if (problem is not null)
        {
            yield return $"json: {problem}";
        }

        foreach ((string part, byte[] content) in sample.Where(pair => pair.Key != "json"))
        {
            if (ImageProblem(part, content, label?.Camera) is { } imageProblem)
            {
                yield return $"{part}: {imageProblem}";
            }
        }
    }

    private static (FrameLabel? Label, string? Problem) ReadLabel(byte[] json)
    {
        try
        {
            return (FrameLabelParser.Parse(Encoding.UTF8.GetString(json)), null);
        }
        catch (DatasetFormatException e)
        {
            return (null, e.Message);
        }
    }

    private static string? ImageProblem(string part, byte[] content, CameraLabel? camera)
    {
        try
        {
            ImageHeader header = ImageHeader.Read(new MemoryStream(content));
            int? bits = part switch
            {
                "mask.png" => MaskBits,
                "classes.png" => ClassBits,
                _ => null,
            };
            return bits is { } wanted && header.BitsPerPixel != wanted ? $"it has {header.BitsPerPixel} bits per pixel instead of {wanted}."
                : camera is not null && (header.Size.Width != camera.Width || header.Size.Height != camera.Height)
                    ? $"it is {header.Size.Width} x {header.Size.Height}, but its label says {camera.Width} x {camera.Height}."
                : bits is not null || part == ImageEnd ? null
                : "it is not a part of a sample.";
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }
}
