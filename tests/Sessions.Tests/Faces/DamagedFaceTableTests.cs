using System.Text;
using FsCheck;
using FsCheck.Fluent;
using Harvester.Sessions.Faces;
using Harvester.TestSupport;

namespace Harvester.Sessions.Tests.Faces;

/// <summary>
/// Tables of faces with damage to a row, to the header, to line ends and to the encoding: nothing is thrown, and no good row is lost.
/// </summary>
public sealed class DamagedFaceTableTests
{
    private const string Header = "model,hash,class,name,mutcd,face,fulX,fulY,fulZ,blrX,blrY,blrZ,facing,provenance,source";

    private static readonly string[] Rows =
    [
        "prop_sign_road_01a,-949234773,sign,STOP,R1-1,0,-0.381,0.000,2.662,0.381,-0.060,1.900,-y,estimated,standard size",
        "prop_sign_road_02a,-639994124,sign,YIELD,R1-2,0,-0.457,0.000,2.692,0.457,-0.060,1.900,-y,measured,\"survey, by \"\"ray\"\"\"",
        "prop_traffic_01a,1043035044,trafficLight,L\u00e4mpchen,,0,-0.200,0.200,3.650,0.200,-0.200,2.600,-y,derived,",
        "865627822 SIGNAL -0.2 0.2 3.65 0.2 -0.2 2.6",
    ];

    private static readonly ModelFace[] Faces = [.. Rows.Select(row => Assert.Single(Read(Bytes(row)).Table.Faces))];

    [Fact]
    [Trait("Category", "Heavy")]
    public void Read_of_100_000_mutations_never_throws_or_loses_a_row() => Mutate(100_000);

    [Fact]
    public void Read_of_mutations_never_throws_or_loses_a_good_row() => Mutate(5_000);

    [Fact]
    public void Read_accepts_every_line_ending()
    {
        string[] ends = ["\n", "\r\n", "\r", "\n\n", " \n", "\t\r\n\r\n", "\n# end\n"];
        Arbitrary<int[]> choices = RandomCases.ArrayOf(RandomCases.Integer(0, ends.Length - 1), Rows.Length + 1);
        RandomCases.Check(
            1_000,
            choices,
            chosen =>
            {
                string text = string.Concat(Rows.Prepend(Header).Select((line, i) => line + ends[chosen[i]]));

                FaceTableContent content = Read(Bytes(text));

                Assert.Empty(content.Problems);
                AssertHas(content, Faces);
            }
        );
    }

    [Fact]
    public void Read_accepts_every_encoding_with_a_byte_order_mark()
    {
        string text = string.Join("\n", Rows.Prepend(Header));
        foreach (
            Encoding encoding in (Encoding[])
                [new UTF8Encoding(false), new UTF8Encoding(true), Encoding.Unicode, Encoding.BigEndianUnicode, Encoding.UTF32]
        )
        {
            FaceTableContent content = Read([.. encoding.GetPreamble(), .. encoding.GetBytes(text)]);

            Assert.Empty(content.Problems);
            AssertHas(content, Faces);
        }
    }

    [Fact]
    public void Read_refuses_rows_that_a_wrong_encoding_would_corrupt()
    {
        FaceTableContent content = Read(Encoding.Latin1.GetBytes(string.Join("\n", Rows.Prepend(Header))));

        Assert.Equal((4, "name"), (Assert.Single(content.Problems).Line, content.Problems[0].Column));
        AssertHas(content, Faces[0], Faces[1], Faces[3]);
    }

    [Fact]
    public void Read_refuses_two_rows_merged_into_one_line()
    {
        FaceTableContent content = Read(Bytes(string.Join("\n", Header, Rows[0] + Rows[1], Rows[2], Rows[3])));

        Assert.Equal(2, Assert.Single(content.Problems).Line);
        AssertHas(content, Faces[2], Faces[3]);
    }

    /// <summary>Damages the bytes of one line, the header's or a row's, and looks for the other rows.</summary>
    private static void Mutate(int mutations)
    {
        byte[] bytes = [.. "0123456789.,-+eE\"'# \t\r\nxyzNaN\0"u8, 0xC3, 0xA4, 0xE2, 0x80, 0xA8, 0xEF, 0xBB, 0xBF, 0xFF, 0xFE];
        Arbitrary<ByteChange[]> changes = ByteChange.Lists(count: 5, maxLength: 8, bytes);
        RandomCases.Check(
            mutations,
            Arb.Zip(RandomCases.Integer(0, Rows.Length), changes),
            drawn =>
            {
                (int damaged, ByteChange[] damage) = drawn;
                byte[][] lines = [.. Rows.Prepend(Header).Select(Bytes)];
                lines[damaged] = ByteChange.Apply(damage, lines[damaged]);

                FaceTableContent content = Read(Joined(lines));

                // After the mark of another encoding, no line is what it was.
                if (lines[0] is not ([0xFE, 0xFF, ..] or [0xFF, 0xFE, ..]))
                {
                    AssertHas(content, [.. Faces.Where((_, row) => row + 1 != damaged)]);
                }
            }
        );
    }

    private static void AssertHas(FaceTableContent content, params ModelFace[] faces) =>
        Assert.All(faces, face => Assert.Contains(face, content.Table.Of(face.Hash)));

    private static byte[] Joined(byte[][] lines) => [.. lines.SelectMany(line => line.Append((byte)'\n'))];

    private static byte[] Bytes(string text) => new UTF8Encoding(false).GetBytes(text);

    private static FaceTableContent Read(byte[] file)
    {
        using var reader = new StreamReader(new MemoryStream(file));
        return FaceTableReader.Read(reader);
    }
}
