using System.Buffers.Binary;
using System.Text;
using System.Text.Json.Nodes;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Commands;
using Harvester.Exports.Formats;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Damage that once ended in an exception or an endless loop: every command that reads it reports it in one line.</summary>
public sealed class DamagedInputTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private readonly HostileSession _hostile = new(session);

    public static TheoryData<string> Readers =>
        [
            "validate SESSION",
            "stats SESSION",
            "report SESSION",
            "report SESSION --still 0 --out OUT.png",
            "relabel SESSION --no-report --out OUT",
            "masks import SESSION SESSION/masks",
            .. Exports,
        ];

    /// <summary>Commands that look objects up by their ids.</summary>
    public static TheoryData<string> LookUps =>
        ["validate SESSION", "relabel SESSION --no-report --out OUT", "masks import SESSION SESSION/masks", .. Exports];

    private static IEnumerable<string> Exports =>
        DatasetFormats.All.Where(format => format.Program is null).Select(format => $"export SESSION --format {format.Name} --out OUT");

    public void Dispose() => _hostile.Dispose();

    [Theory]
    [InlineData(0xFFFFFFF4)]
    [InlineData(0x7FFFFFFF)]
    [InlineData(0x80000000)]
    public void Picture_with_an_impossible_chunk_is_refused(uint length)
    {
        Damage("frames/00000000.png", length);
        Damage("masks/00000000.png", length);

        AssertRefused("damaged", "validate", "SESSION");
        AssertRefused("damaged", "report", "SESSION", "--still", "0", "--out", "OUT.png");
        AssertRefused("damaged", "export", "SESSION", "--format", "coco", "--out", "OUT");
        AssertRefused("damaged", "export", "SESSION", "--format", "csv", "--image-format", "jpg", "--out", "OUT2");
        AssertRefused("damaged", "masks", "import", "SESSION", "SESSION/masks");
    }

    [Theory]
    [MemberData(nameof(Readers))]
    public void Half_a_surrogate_pair_in_a_label_is_refused(string command)
    {
        _hostile.Replace("labels.jsonl", "\"model\":\"", "\"model\":\"\\ud800");

        AssertRefused("surrogate", command.Split(' '));
    }

    [Theory]
    [InlineData("session.json", "\"game\": \"", "validate")]
    [InlineData("session.json", "\"game\": \"", "export", "--format", "csv", "--out", "OUT")]
    [InlineData("session.json", "\"game\": \"", "relabel", "--out", "OUT")]
    [InlineData("scenes/00000000.json", "\"model\":\"", "validate")]
    [InlineData("scenes/00000000.json", "\"model\":\"", "relabel", "--out", "OUT")]
    public void Half_a_surrogate_pair_in_another_file_is_refused(string name, string before, string command, params string[] options)
    {
        _hostile.Replace(name, before, before + "\\udfff");

        AssertRefused("surrogate", [command, "SESSION", .. options]);
    }

    [Theory]
    [MemberData(nameof(LookUps))]
    public void Two_objects_of_one_id_are_refused(string command)
    {
        JsonObject label = Label();
        JsonArray objects = label["objects"]!.AsArray();
        objects.Add(objects[0]!.DeepClone());
        WriteFirst(label);

        AssertRefused("have the id", command.Split(' '));
    }

    [Fact]
    public void Two_entities_of_one_handle_in_a_scene_are_refused()
    {
        JsonNode scene = JsonNode.Parse(File.ReadAllText(_hostile.In("scenes/00000000.json")))!;
        JsonArray entities = scene["entities"]!.AsArray();
        entities.Add(entities[0]!.DeepClone());
        File.WriteAllText(_hostile.In("scenes/00000000.json"), scene.ToJsonString());

        AssertRefused("have the handle", "relabel", "SESSION", "--out", "OUT");
        AssertRefused("have the handle", "validate", "SESSION");
    }

    [Theory]
    [MemberData(nameof(Readers))]
    public void Duplicate_field_is_refused(string command)
    {
        _hostile.Replace("labels.jsonl", "\"objects\":[", "\"objects\":[],\"objects\":[");

        AssertRefused("duplicate field", command.Split(' '));
    }

    [Theory]
    [MemberData(nameof(Readers))]
    public void Coordinate_of_1e300_is_refused(string command)
    {
        JsonObject label = Label();
        label["objects"]![0]!["box3d"]!["centre"]![0] = 1e300;
        WriteFirst(label);

        AssertRefused("1e12 at most", command.Split(' '));
    }

    [Theory]
    [MemberData(nameof(Readers))]
    public void Picture_of_60000_x_60000_is_refused(string command)
    {
        JsonObject label = Label();
        label["camera"]!["width"] = 60000;
        label["camera"]!["height"] = 60000;
        WriteFirst(label);

        AssertRefused("the impossible size 60000 x 60000", command.Split(' '));
    }

    [Fact]
    public void Session_of_60000_x_60000_is_refused()
    {
        _hostile.Replace("session.json", "\"width\": 80", "\"width\": 60000");
        _hostile.Replace("session.json", "\"height\": 60", "\"height\": 60000");

        AssertRefused("the impossible size 60000 x 60000", "relabel", "SESSION", "--out", "OUT");
        AssertRefused("the impossible size 60000 x 60000", "validate", "SESSION");
    }

    [Theory]
    [InlineData("plan.json", "{}")]
    [InlineData("plan.json", "[]")]
    [InlineData("plan.json", "")]
    [InlineData("plan.json", "{\"format\":\"csv\",\"splits\":{\"../x\":1}}")]
    [InlineData("plan.json", "{\"format\":\"\\ud800\"}")]
    [InlineData("journal-1-of-2.jsonl", "{}\nend\n")]
    [InlineData("journal-1-of-2.jsonl", "[]\nend\n")]
    [InlineData(
        "journal-1-of-2.jsonl",
        "{\"frame\":0,\"split\":\"other\",\"labels\":0,\"objects\":0,\"ignored\":0,"
            + "\"files\":[{\"path\":\"images/00000000.png\",\"bytes\":1,\"sha256\":\"\"}],\"parts\":[]}\nend\n"
    )]
    [InlineData(
        "journal-1-of-2.jsonl",
        "{\"frame\":0,\"split\":\"train\",\"labels\":0,\"objects\":0,\"ignored\":0,"
            + "\"files\":[\"images/00000000.png\"],\"parts\":[]}\nend\n"
    )]
    [InlineData(
        "journal-1-of-2.jsonl",
        "{\"frame\":0,\"split\":\"train\",\"labels\":0,\"objects\":0,\"ignored\":0,\"files\":[]," + "\"parts\":[\"train\"]}\nend\n"
    )]
    [InlineData("journal-x-of-2.jsonl", "end\n")]
    [InlineData("journal-1-of-2147483647.jsonl", "end\n")]
    public void Merge_of_a_damaged_shard_is_refused(string name, string content)
    {
        string[] shards = [_hostile.PathOf("1"), _hostile.PathOf("2")];
        for (int i = 0; i < shards.Length; i++)
        {
            Assert.Equal(
                ExitCode.Done,
                CliRun.Of("export", _hostile.Folder, "--format", "csv", "--shard", $"{i + 1}/2", "--out", shards[i]).ExitCode
            );
        }

        File.WriteAllText(Path.Combine(shards[0], ".export", name), content);

        AssertRefused("", "merge", shards[0], shards[1], "--out", "OUT");
    }

    [Theory]
    [InlineData("export.json", "{}")]
    [InlineData("export.json", "[]")]
    [InlineData("export.json", "\"")]
    [InlineData("export.json", "{\"plan\":{\"format\":\"csv\"}}")]
    [InlineData("export.json", "{\"plan\":7}")]
    public void Damaged_manifest_of_a_dataset_is_refused(string name, string content)
    {
        ExportCsv();
        File.WriteAllText(_hostile.PathOf("csv/" + name), content);

        AssertRefused("export.json", "validate", _hostile.PathOf("csv"));
    }

    [Theory]
    [InlineData("frames.csv", ",80,60,", ",0,-5,")]
    [InlineData("frames.csv", ",80,60,", ",1e300,60,")]
    [InlineData("frames.csv", ",80,60,", ",,60,")]
    [InlineData("frames.csv", "images/", "../../")]
    [InlineData("frames.csv", "0,train", "\"0,train")]
    [InlineData("objects.csv", "0,", "\u0000\"\r\"0,")]
    public void Damaged_csv_dataset_is_refused(string name, string old, string with)
    {
        ExportCsv();
        string path = _hostile.PathOf("csv/" + name);
        string text = File.ReadAllText(path);
        int at = text.IndexOf(old, text.IndexOf('\n', StringComparison.Ordinal) + 1, StringComparison.Ordinal);
        File.WriteAllText(path, text[..at] + with + text[(at + old.Length)..]);

        AssertRefused(name, "validate", _hostile.PathOf("csv"));
    }

    /// <summary>An unknown entry, a key out of range, a call with more arguments than bytes, readings of the clock before 0.</summary>
    [Theory]
    [InlineData(new byte[] { 10 }, "an unknown entry")]
    [InlineData(new byte[] { 4, 255, 255, 255, 255, 255, 1 }, "a number out of range")]
    [InlineData(new byte[] { 5, 0, 1, 2, 3, 4, 5, 6, 7, 8, 255, 255, 3 }, "cut off")]
    [InlineData(new byte[] { 6, 0x81, 0xC4, 0x13 }, "the clock")]
    [InlineData(new byte[] { 6, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1 }, "the clock")]
    public void Damaged_tape_is_refused(byte[] entry, string message)
    {
        string tape = _hostile.PathOf("damaged.tape");
        File.WriteAllBytes(tape, TapeBytes.Of(TapeBytes.Idle.SkipLast(1), entry));

        AssertRefused(message, "tape", "play", tape);
    }

    private void ExportCsv() =>
        Assert.Equal(ExitCode.Done, CliRun.Of("export", _hostile.Folder, "--format", "csv", "--out", _hostile.PathOf("csv")).ExitCode);

    private void AssertRefused(string message, params string[] command) =>
        HostileSession.AssertRefused(
            message,
            [
                .. command.Select(word =>
                    word.Replace("OUT", _hostile.PathOf("out"), StringComparison.Ordinal)
                        .Replace("SESSION", _hostile.Folder, StringComparison.Ordinal)
                ),
            ]
        );

    /// <summary>Gives the first chunk of pixels another length.</summary>
    private void Damage(string name, uint length)
    {
        byte[] picture = File.ReadAllBytes(_hostile.In(name));
        int at = picture.AsSpan().IndexOf(Encoding.ASCII.GetBytes("IDAT"));
        BinaryPrimitives.WriteUInt32BigEndian(picture.AsSpan(at - 4), length);
        File.WriteAllBytes(_hostile.In(name), picture);
    }

    private JsonObject Label() => JsonNode.Parse(File.ReadLines(_hostile.In("labels.jsonl")).First())!.AsObject();

    private void WriteFirst(JsonObject label) =>
        File.WriteAllLines(
            _hostile.In("labels.jsonl"),
            [label.ToJsonString(), .. File.ReadLines(_hostile.In("labels.jsonl")).Skip(1).ToArray()]
        );
}
