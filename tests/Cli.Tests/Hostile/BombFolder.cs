using System.Buffers.Binary;
using System.Globalization;
using System.IO.Compression;
using System.Text;
using System.Text.Json.Nodes;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Files that are small on the disk, or simple to write, and that cost memory if nothing limits it.</summary>
internal sealed class BombFolder : IDisposable
{
    private const int Megabyte = 1 << 20;
    private const int LargestSide = 8192;
    private readonly TemporaryFolder _folder = new();

    public string Folder => _folder.Path;

    public void Dispose() => _folder.Dispose();

    public string PathOf(string name) => _folder.PathOf(name);

    /// <summary>Writes a text that begins in one way and goes on in another.</summary>
    public string File(string name, string start, string again = "", int megabytes = 0)
    {
        using FileStream file = System.IO.File.Create(PathOf(name));
        Fill(file, start, again, megabytes);
        return file.Name;
    }

    public static void Fill(Stream stream, string start, string again, int megabytes)
    {
        stream.Write(Encoding.UTF8.GetBytes(start));
        byte[] block = Encoding.UTF8.GetBytes(again.Length == 0 ? "" : string.Concat(Enumerable.Repeat(again, Megabyte / again.Length)));
        for (int i = 0; i < megabytes; i++)
        {
            stream.Write(block);
        }
    }

    /// <summary>The zip of a self-test whose selftest.json unpacks to so much.</summary>
    public string SelfTest(int megabytes)
    {
        string path = PathOf("selftest.zip");
        using var zip = ZipFile.Open(path, ZipArchiveMode.Create);
        using Stream entry = zip.CreateEntry("selftest.json", CompressionLevel.Fastest).Open();
        Fill(entry, "{", " ", megabytes);
        return path;
    }

    public string Roads() => Path.Combine(SmallSession(), "scenes/roads.csv");

    public string SmallSession()
    {
        string folder = PathOf("session");
        SharedHarvest.CopyTo(folder, "--frames", "1", "--seed", "5", "--size", "80x60", "--masks", "--no-report");
        return folder;
    }

    public string Dataset(string format)
    {
        string folder = PathOf("dataset");
        Run("export", SmallSession(), "--format", format, "--out", folder);
        return folder;
    }

    /// <summary>A session whose picture and mask have the largest size that is read.</summary>
    public string SessionOfLargePictures()
    {
        string session = SmallSession();
        foreach (string name in (string[])["session.json", "labels.jsonl"])
        {
            string path = Path.Combine(session, name);
            System.IO.File.WriteAllText(
                path,
                System
                    .IO.File.ReadAllText(path)
                    .Replace("\"width\":80,\"height\":60", $"\"width\":{LargestSide},\"height\":{LargestSide}", StringComparison.Ordinal)
                    .Replace("\"width\": 80", $"\"width\": {LargestSide}", StringComparison.Ordinal)
                    .Replace("\"height\": 60", $"\"height\": {LargestSide}", StringComparison.Ordinal)
            );
        }

        WritePng(Path.Combine(session, "frames/00000000.png"), LargestSide, LargestSide, unpackedMegabytes: null);
        WritePng(Path.Combine(session, "masks/00000000.png"), LargestSide, LargestSide, unpackedMegabytes: null, isMask: true);
        return session;
    }

    /// <summary>A session of a hundred frames with as many labels as a line may have.</summary>
    public string SessionOfManyLabels()
    {
        const int labels = 4000;
        string session = SmallSession();
        string path = Path.Combine(session, "labels.jsonl");
        JsonNode frame = JsonNode.Parse(System.IO.File.ReadAllText(path))!;
        string label = frame["objects"]!.AsArray().First(item => item!["parent"] is null)!.ToJsonString();
        string before = frame.ToJsonString();
        int at = before.IndexOf("\"objects\":[", StringComparison.Ordinal) + "\"objects\":[".Length;
        frame["objects"]!.AsArray().Clear();
        string empty = frame.ToJsonString();
        string id = label[label.IndexOf("\"id\":", StringComparison.Ordinal)..label.IndexOf(',', StringComparison.Ordinal)];
        string objects = string.Join(
            ',',
            Enumerable.Range(1, labels).Select(number => label.Replace(id, $"\"id\":{number}", StringComparison.Ordinal))
        );
        using StreamWriter text = System.IO.File.CreateText(path);
        for (int i = 0; i < 100; i++)
        {
            string start = string.Create(CultureInfo.InvariantCulture, $"{{\"frame\":{i},");
            text.Write(empty[..at].Replace("{\"frame\":0,", start, StringComparison.Ordinal));
            text.Write(objects);
            text.Write(empty[at..] + "\n");
        }

        return session;
    }

    /// <summary>A survey whose photographs together are larger than a page may be.</summary>
    public string Gallery(int pictures, int megabytes)
    {
        string folder = Directory.CreateDirectory(PathOf("survey")).FullName;
        Directory.CreateDirectory(Path.Combine(folder, "photos"));
        File("survey/spaces.csv", "prop_sign_road_01a,-949234773,sign,STOP,R1-1,0,-0.5,-0.04,3,0.5,-0.06,1.5,-y,measured,a test\n");
        var rows = new StringBuilder("file,model,x,y,z,pitch,roll,yaw,verticalFov\n");
        for (int i = 0; i < pictures; i++)
        {
            string name = string.Create(CultureInfo.InvariantCulture, $"{i}.png");
            rows.Append(CultureInfo.InvariantCulture, $"{name},prop_sign_road_01a,0,-3,2,0,0,0,50\n");
            string path = Path.Combine(folder, "photos", name);
            WritePng(path, width: 80, height: 60, unpackedMegabytes: null);
            byte[] end = System.IO.File.ReadAllBytes(path)[^12..];
            using FileStream file = System.IO.File.OpenWrite(path);
            file.SetLength((long)megabytes * Megabyte);
            file.Seek(-end.Length, SeekOrigin.End);
            file.Write(end);
        }

        File("survey/photos.csv", rows.ToString());
        return folder;
    }

    /// <summary>A WebDataset with one archive that is a bomb.</summary>
    public string WebDataset(string bomb)
    {
        string dataset = Dataset("webdataset");
        string path = Path.Combine(dataset, "train-000000.tar");
        using FileStream file = System.IO.File.Create(path);
        switch (bomb)
        {
            case "entry of 2 GB":
                WriteEntry(file, "00000000.png", '0', 2000L * Megabyte);
                break;
            case "name of 1 GB":
                WriteEntry(file, "x", 'x', 1000L * Megabyte);
                WriteEntry(file, "00000000.png", '0', 0);
                break;
            case "sample of 2 GB":
                for (int i = 0; i < 20; i++)
                {
                    WriteEntry(file, string.Create(CultureInfo.InvariantCulture, $"00000000.{i}"), '0', 100L * Megabyte);
                }

                break;
            default:
                for (int i = 0; i < 300_000; i++)
                {
                    WriteEntry(file, string.Create(CultureInfo.InvariantCulture, $"{i:D8}.png"), '0', 0);
                }

                break;
        }

        file.SetLength(file.Position + 1024);
        return dataset;
    }

    /// <summary>A black PNG, or one that unpacks to more than its size.</summary>
    public static void WritePng(string path, int width, int height, int? unpackedMegabytes, bool isMask = false)
    {
        using FileStream file = System.IO.File.Create(path);
        file.Write([0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A]);
        byte[] header = new byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        header[8] = (byte)(isMask ? 16 : 8);
        header[9] = (byte)(isMask ? 0 : 2);
        WriteChunk(file, "IHDR", header);
        using (var packed = new MemoryStream())
        {
            using (var zlib = new ZLibStream(packed, CompressionLevel.Fastest, leaveOpen: true))
            {
                byte[] row = new byte[1 + (width * (isMask ? 2 : 3))];
                long bytes = unpackedMegabytes is { } megabytes ? megabytes * (long)Megabyte : (long)height * row.Length;
                for (long written = 0; written < bytes; written += row.Length)
                {
                    zlib.Write(row);
                }
            }

            WriteChunk(file, "IDAT", packed.ToArray());
        }

        WriteChunk(file, "IEND", []);
    }

    private static void WriteChunk(FileStream file, string type, byte[] content)
    {
        byte[] named = [.. Encoding.ASCII.GetBytes(type), .. content];
        Span<byte> number = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, content.Length);
        file.Write(number);
        file.Write(named);
        BinaryPrimitives.WriteUInt32BigEndian(number, Crc(named));
        file.Write(number);
    }

    /// <summary>The header of an entry, and a hole in the place of its content.</summary>
    private static void WriteEntry(FileStream file, string name, char type, long length)
    {
        byte[] header = new byte[512];
        Encoding.ASCII.GetBytes(name, header);
        Encoding.ASCII.GetBytes("0000644\00000000\00000000\0", header.AsSpan(100));
        Encoding.ASCII.GetBytes(Convert.ToString(length, 8).PadLeft(11, '0') + "\000000000000\0", header.AsSpan(124));
        header[156] = (byte)type;
        Encoding.ASCII.GetBytes("ustar\000", header.AsSpan(257));
        header.AsSpan(148, 8).Fill((byte)' ');
        int sum = header.Sum(static value => value);
        Encoding.ASCII.GetBytes(Convert.ToString(sum, 8).PadLeft(6, '0') + "\0 ", header.AsSpan(148));
        file.Write(header);
        file.SetLength(file.Position + ((length + 511) / 512 * 512));
        file.Seek(0, SeekOrigin.End);
    }

    private static uint Crc(byte[] bytes)
    {
        uint crc = uint.MaxValue;
        foreach (byte value in bytes)
        {
            crc ^= value;
            for (int bit = 0; bit < 8; bit++)
            {
                crc = (crc >> 1) ^ ((crc & 1) * 0xEDB88320);
            }
        }

        return ~crc;
    }

    private static void Run(params string[] arguments)
    {
        CliRun run = CliRun.Of(arguments);
        Assert.True(run.ExitCode == ExitCode.Done, run.Error);
    }
}
