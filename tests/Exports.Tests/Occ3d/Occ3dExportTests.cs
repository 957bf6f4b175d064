using System.IO.Compression;
using System.Text.Json;
using Harvester.Exports.Formats.NuScenes;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Occ3d;

/// <summary>Occ3D exports have the scenes and tokens of nuScenes, and damage to them is found.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class Occ3dExportTests(SimulatedSession simulated) : CheckTests(simulated, "occ3d")
{
    private const string Annotations = "annotations.json";
    private const string Sample = "\"[0-9a-f]{32}\":\\{\"timestamp\"";

    private readonly SimulatedSession _simulated = simulated;

    private static string FirstToken => NuScenesToken.Of("sample", 0, 0);

    private static string FirstLabels => $"gts/scene-2001/{FirstToken}/labels.npz";

    [Fact]
    public void Tokens_and_times_are_those_of_the_nuscenes_export()
    {
        Export();
        Folder.Export("nuscenes", _simulated.OpenWithVoxels(), to: "nuscenes");
        Assert.Empty(Problems());
        using var annotations = JsonDocument.Parse(File.ReadAllText(Folder.PathOf($"out/{Annotations}")));
        JsonElement scene = Assert.Single(annotations.RootElement.GetProperty("scene_infos").EnumerateObject()).Value;
        using var samples = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("nuscenes/v1.0-gta/sample.json")));
        using var data = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("nuscenes/v1.0-gta/sample_data.json")));
        var cameras = data.RootElement.EnumerateArray().ToDictionary(record => record.GetProperty("token").GetString()!);

        Assert.Equal(SimulatedSession.Frames, samples.RootElement.GetArrayLength());
        foreach (JsonElement sample in samples.RootElement.EnumerateArray())
        {
            JsonElement moment = scene.GetProperty(sample.GetProperty("token").GetString()!);
            Assert.Equal(sample.GetProperty("timestamp").GetRawText(), moment.GetProperty("timestamp").GetString());
            Assert.Equal(sample.GetProperty("next").GetString(), moment.GetProperty("next").GetString());
            JsonProperty camera = Assert.Single(moment.GetProperty("camera_sensor").EnumerateObject());
            Assert.Equal(
                Path.GetFileName(cameras[camera.Name].GetProperty("filename").GetString()),
                Path.GetFileName(camera.Value.GetProperty("img_path").GetString())
            );
        }
    }

    [Fact]
    public void Session_without_voxels_is_refused()
    {
        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() => Folder.Export("occ3d", _simulated.Open()));

        Assert.EndsWith(
            "frame 0: it has no voxels, which occ3d needs. Harvest with --occupancy.",
            refused.Message,
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData("occ3d", "\"cellMetres\":0.4", "\"cellMetres\":0.5", "its voxels are not 200 x 200 x 16 of 0.4 m from -1 m on")]
    [InlineData("mcap", "\"cells\":200", "\"cells\":600", "it has 5760000 voxels, and mcap takes at most 4000000.")]
    public void Voxels_of_another_size_are_refused(string format, string of, string other, string expected)
    {
        string folder = CopyOfSession();
        string labels = Path.Combine(folder, SessionReader.LabelsFile);
        File.WriteAllText(labels, File.ReadAllText(labels).Replace(of, other, StringComparison.Ordinal));

        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() =>
            Folder.Export(format, new SessionReader(folder), to: "other")
        );

        Assert.Contains($"frame 0: {expected}", refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Lost_voxels_are_found() =>
        AssertLossIsFound(FirstLabels, $"{Annotations}, line 3: its voxels '{FirstLabels}' are missing.");

    [Fact]
    public void Class_that_does_not_exist_is_found()
    {
        Export();
        ChangeVoxels("semantics", 18);

        AssertFound($"{Annotations}, line 3: its voxels '{FirstLabels}': semantics has a value above 17");
    }

    [Theory]
    [InlineData("mask_lidar")]
    [InlineData("mask_camera")]
    public void Mask_that_is_no_mask_is_found(string mask)
    {
        Export();
        ChangeVoxels(mask, 2);

        AssertFound($"{Annotations}, line 3: its voxels '{FirstLabels}': {mask} has a value other than 0 and 1.");
    }

    [Fact]
    public void Array_of_another_shape_is_found()
    {
        Export();
        using (ZipArchive archive = ZipFile.Open(Folder.PathOf($"out/{FirstLabels}"), ZipArchiveMode.Update))
        {
            archive.GetEntry("mask_camera.npy")!.Delete();
        }

        AssertFound($"{Annotations}, line 3: its voxels '{FirstLabels}': it does not have semantics, mask_lidar, mask_camera of 200 x 200");
    }

    [Theory]
    [InlineData("\"next\":\"[0-9a-f]", "\"next\":\"x", "4: prev and next do not lead")]
    [InlineData("\"img_path\":\"imgs", "\"img_path\":\"img", "3: its image")]
    [InlineData("\"intrinsic\":\\[\\[", "\"intrinsic\":[[-", "3: its intrinsic is no camera matrix.")]
    [InlineData("\"rotation\":\\[[^,]+", "\"rotation\":[2", "3: the rotation of its extrinsic is no unit quaternion.")]
    [InlineData("\"gt_path\":\"gts", "\"gt_path\":\"gt", "3: its gt_path is not")]
    [InlineData("\"timestamp\":\"", "\"timestamp\":\"x", "3: its timestamp is no number.")]
    [InlineData("\"\\},\n", "\"}\n", "4: the comma before it is missing")]
    [InlineData("\"scene-2001\":\\{", "\"scene-2001\":", "2: ")]
    [InlineData("\\[\"scene-2001\"\\]", "[\"scene-2002\"]", "12: the scene 'scene-2002' is unknown.")]
    [InlineData("\"train_split\"", "\"val_split\"", "12: 'val_split' is no split")]
    public void Damaged_annotations_are_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Annotations, pattern, replacement, $"{Annotations}, line {expected}");

    [Fact]
    public void Scene_of_no_split_is_found() =>
        AssertDamageIsFound(Annotations, "\\[\"scene-2001\"\\]", "[]", $"{Annotations}: the scene 'scene-2001' is in no split.");

    [Fact]
    public void Cut_annotations_are_found() =>
        AssertDamageIsFound(Annotations, $"{Sample}[\\s\\S]*", "", $"{Annotations}, line 2: the file ends too early.");

    /// <summary>Changes the first voxel of an array of the first moment.</summary>
    private void ChangeVoxels(string array, byte value)
    {
        using ZipArchive archive = ZipFile.Open(Folder.PathOf($"out/{FirstLabels}"), ZipArchiveMode.Update);
        using Stream stream = archive.GetEntry($"{array}.npy")!.Open();

        // An .npy file of three short axes has a header of 128 bytes.
        stream.Position = 128;
        stream.WriteByte(value);
    }

    private string CopyOfSession()
    {
        string from = _simulated.OpenWithVoxels().Folder;
        string to = Folder.PathOf("session");
        foreach (string file in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            string path = Path.Combine(to, Path.GetRelativePath(from, file));
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            File.Copy(file, path);
        }

        return to;
    }
}
