using System.Text.RegularExpressions;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.NuScenes;

public sealed class NuScenesCheckTests(SimulatedSession simulated) : CheckTests(simulated, "nuscenes")
{
    private const string Tables = "v1.0-gta/";

    [Theory]
    [InlineData("sample_annotation", "instance_token\":\"[0-9a-f]", "instance_token\":\"x", "instance_token is no token of instance.")]
    [InlineData("sample_data", "\"ego_pose_token\":\"[0-9a-f]", "\"ego_pose_token\":\"x", "ego_pose_token is no token of ego_pose.")]
    [InlineData("sample", "\"next\":\"[0-9a-f]+\"", "\"next\":\"\"", "the record before it does not point to it.")]
    [InlineData("sample_annotation", "\"size\":\\[[^,]*", "\"size\":[0", "its size is not above 0.")]
    [InlineData("sample_annotation", "\"rotation\":\\[[^,]*", "\"rotation\":[2", "its rotation is no unit quaternion.")]
    public void Damaged_record_is_found(string table, string pattern, string replacement, string expected)
    {
        Export();
        Damage($"{Tables}{table}.json", pattern, replacement);
        Assert.Contains(
            Problems(),
            problem =>
                problem.StartsWith($"{Tables}{table}.json: ", StringComparison.Ordinal)
                && problem.EndsWith(expected, StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Token_that_occurs_twice_is_found() =>
        AssertDamageIsFound(
            Tables + "visibility.json",
            "\"token\":\"2\"",
            "\"token\":\"1\"",
            $"{Tables}visibility.json: line 3: the token 1 occurs twice."
        );

    [Theory]
    [InlineData("},\n", "}\n", "line 3: a comma must follow the record before.")]
    [InlineData("\n\\]", ",\n]", "line 6: a record must follow the comma.")]
    [InlineData("^\\[", "{", "line 1: it does not begin a list of records.")]
    [InlineData("\n\\]\n", "\n", "it is cut off.")]
    public void Table_that_is_no_list_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Tables + "visibility.json", pattern, replacement, $"{Tables}visibility.json: {expected}");

    [Fact]
    public void Lost_table_is_found() => AssertLossIsFound(Tables + "log.json", $"{Tables}log.json: it is missing.");

    [Fact]
    public void Location_with_the_name_of_a_map_that_is_missing_is_found()
    {
        Export();
        Damage(Tables + "log.json", "\"location\":\"[^\"]*", "\"location\":\"boston-seaport");
        Assert.Contains(
            Problems(),
            problem => problem.EndsWith("its map 'maps/expansion/boston-seaport.json' is missing.", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Lost_map_is_found()
    {
        Export();
        Delete("maps/scene-2001.png");
        Assert.Contains(Problems(), problem => problem.Contains("its file 'maps/scene-2001.png' is missing.", StringComparison.Ordinal));
    }

    [Fact]
    public void Lost_offsets_of_maps_are_found() =>
        AssertLossIsFound(Tables + "map_offset.json", $"{Tables}map_offset.json: it is missing.");

    [Fact]
    public void Pose_outside_its_map_is_found()
    {
        Export();
        Damage(Tables + "ego_pose.json", "\"translation\":\\[", "\"translation\":[-");
        Assert.Contains(Problems(), problem => problem.EndsWith("it lies outside its map.", StringComparison.Ordinal));
    }

    [Fact]
    public void Boxes_that_all_lie_on_their_sides_are_found()
    {
        Export();
        string table = Folder.PathOf($"out/{Tables}sample_annotation.json");
        File.WriteAllText(
            table,
            Regex.Replace(File.ReadAllText(table), "\"rotation\":\\[[^\\]]*", "\"rotation\":[0.707106781,0.707106781,0,0")
        );
        Assert.Contains(
            Problems(),
            problem => problem.EndsWith("boxes lean by more than 60 degrees: rotation is w, x, y, z.", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Scene_that_is_in_no_split_is_found() =>
        AssertDamageIsFound(Tables + "splits.json", "\"scene-2001\"", "", $"{Tables}splits.json: it does not have each scene once.");
}
