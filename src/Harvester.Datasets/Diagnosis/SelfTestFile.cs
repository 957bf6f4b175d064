using System.IO.Compression;
using System.Text.Json;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.SelfTests;

namespace Harvester.Datasets.Diagnosis;

/// <summary>The results of the mod's self-test: selftest.json, alone or in the zip that the mod writes.</summary>
/// <param name="Tool">Name and version of the mod.</param>
/// <param name="Game">Name and version of the game.</param>
/// <param name="IsComplete">Whether the test ran to its end.</param>
/// <param name="Lines">The result of each check.</param>
/// <param name="Changes">The settings that the mod changed, as NAME = VALUE.</param>
public sealed record SelfTestFile(
    string Tool,
    string Game,
    bool IsComplete,
    IReadOnlyList<SelfTestLine> Lines,
    IReadOnlyList<string> Changes
)
{
    /// <summary>Largest size of selftest.json, bytes: a hundred times that of a result.</summary>
    private const int MaxBytes = 1 << 20;

    /// <summary>Largest size of a zip, bytes: ten times that of usual pictures. The list of its entries then fits into memory.</summary>
    private const long MaxZipBytes = 64 << 20;

    /// <summary>Whether a file is selftest.json or a zip, by its name.</summary>
    public static bool HasName(string path) =>
        path.EndsWith(".zip", StringComparison.OrdinalIgnoreCase)
        || string.Equals(Path.GetFileName(path), SelfTestJson.FileName, StringComparison.OrdinalIgnoreCase);

    /// <summary>Reads the file; of a zip only selftest.json is unpacked, into memory.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="DatasetFormatException">It is not the result of a self-test.</exception>
    public static SelfTestFile Read(string path)
    {
        try
        {
            using JsonDocument document = JsonInput.Parse(Bytes(path));
            return Of(new JsonFields(document.RootElement));
        }
        catch (Exception exception)
            when (exception
                    is JsonException
                        or DatasetFormatException
                        or InvalidDataException
                        or NotSupportedException
                        or EndOfStreamException
            )
        {
            throw new DatasetFormatException($"{path}: this is not the result of a self-test: {JsonFault.InText(exception)}", exception);
        }
    }

    private static byte[] Bytes(string path)
    {
        using FileStream file = InputFile.OpenRead(path);
        if (!path.EndsWith(".zip", StringComparison.OrdinalIgnoreCase))
        {
            return Bytes(file);
        }

        if (file.Length > MaxZipBytes)
        {
            throw new DatasetFormatException(FormattableString.Invariant($"it has more than {MaxZipBytes} bytes."));
        }

        using var zip = new ZipArchive(file);
        ZipArchiveEntry entry =
            zip.GetEntry(SelfTestJson.FileName) ?? throw new DatasetFormatException($"it has no {SelfTestJson.FileName}.");
        using Stream unpacked = entry.Open();
        return Bytes(unpacked);
    }

    /// <summary>Reads a stream to its end, whatever size it claims.</summary>
    private static byte[] Bytes(Stream stream)
    {
        byte[] bytes = new byte[MaxBytes + 1];
        int count = stream.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false);
        return count <= MaxBytes
            ? bytes[..count]
            : throw new DatasetFormatException(FormattableString.Invariant($"{SelfTestJson.FileName} has more than {MaxBytes} bytes."));
    }

    private static SelfTestFile Of(JsonFields fields)
    {
        if (fields.Integer("formatVersion") != SelfTestJson.FormatVersion || fields.Text("kind") != "selfTest")
        {
            throw new DatasetFormatException("its format is unknown. Use the harvester of the mod's version.");
        }

        SelfTestLine[] lines =
        [
            .. fields
                .List("checks")
                .Select(line => new SelfTestLine(line.Text("check"), line.Name<SelfTestVerdict>("verdict"), line.Text("finding"))),
        ];
        JsonFields changes = fields.Fields("changedSettings");
        return new SelfTestFile(
            fields.Text("tool"),
            fields.Text("game"),
            fields.Boolean("isComplete"),
            lines,
            [.. changes.Names.Select(name => $"{name} = {changes.Text(name)}")]
        );
    }
}
