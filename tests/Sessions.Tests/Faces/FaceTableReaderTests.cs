using Harvester.Geometry;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Tests.Faces;

public sealed class SpaceTableReaderTests
{
    private const string Header = "model,hash,class,name,mutcd,face,fulX,fulY,fulZ,blrX,blrY,blrZ,facing,provenance,source\n";
    private const string Stop =
        "prop_sign_road_01a,-949234773,sign,STOP,R1-1,0,-0.381,0.000,2.662,0.381,-0.060,1.900,-y,estimated,standard size";
    private const string Yield =
        "prop_sign_road_02a,-639994124,sign,YIELD,R1-2,0,-0.457,0.000,2.692,0.457,-0.060,1.900,-y,measured,\"survey, by ray\"";

    [Fact]
    public void Read_good_rows_gives_all_fields()
    {
        FaceTableContent content = Read(Header + Stop + "\n" + Yield + "\n");

        Assert.Empty(content.Problems);
        ModelFace yield = Assert.Single(content.Table.Of("prop_sign_road_02a"));
        Assert.Equal(
            new ModelFace(
                "prop_sign_road_02a",
                -639994124,
                ObjectClass.Sign,
                "YIELD",
                "R1-2",
                0,
                new Vector3D(-0.457, 0, 2.692),
                new Vector3D(0.457, -0.06, 1.9),
                Facing.Back,
                Provenance.Measured,
                "survey, by ray"
            ),
            yield
        );
    }

    [Fact]
    public void Read_rows_of_the_thesis_numbers_the_faces()
    {
        FaceTableContent content = Read("-949234773 STOP -0.4 0 2.7 0.4 -0.1 1.9\n-949234773 BACK -0.4 0 2.7 0.4 -0.1 1.9\n");

        Assert.Empty(content.Problems);
        Assert.Equal(["STOP", "BACK"], content.Table.Of(-949234773).Select(face => face.Name));
        Assert.Equal([0, 1], content.Table.Of(-949234773).Select(face => face.Number));
    }

    [Theory]
    [InlineData("-949234773", "-949234774", "hash")]
    [InlineData("-949234773", "stop", "hash")]
    [InlineData(",sign,", ",lamp,", "class")]
    [InlineData(",0,-0.381", ",-1,-0.381", "face")]
    [InlineData("-0.381", "-0,381", "row")]
    [InlineData("2.662", "NaN", "fulZ")]
    [InlineData("1.900", "1e9", "blrZ")]
    [InlineData("2.662", "1.8", "fulZ, blrZ")]
    [InlineData(",0.381", ",-0.5", "fulX, blrX")]
    [InlineData("-0.060", "0.001", "fulY, blrY")]
    [InlineData("-0.060,1.900", "0.060,2.662", "fulY, blrY, fulZ, blrZ")]
    [InlineData("prop_sign_road_01a,-949234773", "model,-949234773", "hash")]
    [InlineData("STOP", "30\" STOP", "row")]
    [InlineData("STOP", "\"STOP\" sign", "row")]
    [InlineData("STOP", "ST\uFFFDP", "name")]
    [InlineData("standard", "stan\0dard", "source")]
    [InlineData(",-y,", ",-z,", "facing")]
    [InlineData("estimated", "guessed", "provenance")]
    [InlineData("estimated", "3", "provenance")]
    [InlineData("standard size", "\"standard", "row")]
    public void Read_refuses_a_bad_row_with_line_and_column_and_keeps_others(string good, string bad, string column)
    {
        FaceTableContent content = Read(Header + Yield + "\n" + Stop.Replace(good, bad, StringComparison.Ordinal) + "\n");

        FaceTableProblem problem = Assert.Single(content.Problems);
        Assert.Equal(3, problem.Line);
        Assert.Equal(column, problem.Column);
        Assert.Single(content.Table.Of("prop_sign_road_02a"));
        Assert.Empty(content.Table.Of("prop_sign_road_01a"));
    }

    [Fact]
    public void Read_row_that_starts_like_the_header_is_a_row()
    {
        string model = Stop.Replace("prop_sign_road_01a,-949234773", "model,", StringComparison.Ordinal);

        FaceTableContent content = Read(Header + model + "\n");

        Assert.Empty(content.Problems);
        Assert.Single(content.Table.Of("model"));
    }

    [Theory]
    [InlineData("model,hash,class\n", 1)]
    [InlineData("model,hash,class,name,mutcd,face,fulX,fulY,fulZ,blrX,blrY,blrZ,provenance,facing,source\n", 1)]
    [InlineData("\"model\",hash,CLASS, name,mutcd,face,fulX,fulY,fulZ,blrX,blrY,blrZ,facing,provenance,source\n", 0)]
    [InlineData("", 0)]
    public void Read_reports_an_unknown_header_and_uses_the_rows(string header, int problems)
    {
        FaceTableContent content = Read(header + Stop + "\n" + Yield + "\n");

        Assert.Equal(problems, content.Problems.Count);
        Assert.All(content.Problems, problem => Assert.Equal(1, problem.Line));
        Assert.Equal(2, content.Table.Faces.Count());
    }

    [Fact]
    public void Read_second_row_of_a_face_is_refused_and_the_first_kept()
    {
        FaceTableContent content = Read(Header + Stop + "\n" + Stop.Replace("STOP", "HALT", StringComparison.Ordinal) + "\n");

        Assert.Equal("STOP", Assert.Single(content.Table.Faces).Name);
        Assert.Equal(3, Assert.Single(content.Problems).Line);
    }

    [Fact]
    public void Read_of_what_was_written_gives_the_same_table()
    {
        FaceTable table = Read(Header + Stop + "\n" + Yield + "\n").Table;
        using var text = new StringWriter();

        FaceTableWriter.Write(table, text);

        Assert.Equal(Header + Stop + "\n" + Yield + "\n", text.ToString());
    }

    [Fact]
    public void OverriddenBy_replaces_all_faces_of_a_model_and_no_others()
    {
        FaceTable shipped = Read(Header + Stop + "\n" + Yield + "\n").Table;
        FaceTable own = Read(Header + Stop.Replace("STOP", "HALT", StringComparison.Ordinal) + "\n").Table;

        FaceTable both = shipped.OverriddenBy(own);

        Assert.Equal(["HALT", "YIELD"], both.Faces.Select(face => face.Name));
    }

    private static FaceTableContent Read(string text)
    {
        using var reader = new StringReader(text);
        return FaceTableReader.Read(reader);
    }
}
