using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Windows.Forms;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Settings;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>What GtaDataHarvester.ini says. What it means and which values it takes stands in that file.</summary>
internal sealed class ModSettings
{
    public const string FileName = "GtaDataHarvester.ini";
    private const double LargestOffsetMetres = 20;

    private ModSettings(IniFile ini, string modFolder)
    {
        SpawnKey = Key(ini, "SpawnTestCar", Keys.NumPad0);
        MountKey = Key(ini, "MountCamera", Keys.I);
        RestoreKey = Key(ini, "RestoreCamera", Keys.O);
        HarvestKey = Key(ini, "Harvest", Keys.J);
        FrameKey = Key(ini, "OneFrame", Keys.K);
        OverlayKey = Key(ini, "Overlay", Keys.L);
        CarModel = ini.Text("TestCar", "Model", "adder");
        CarPlate = ini.Text("TestCar", "Plate", "HARVEST");
        VerticalFovDegrees = ini.Number("Camera", "VerticalFov", 50, 1, 130);
        CameraOffset = new Vector3D(Offset(ini, "OffsetRight", 0), Offset(ini, "OffsetForward", 2), Offset(ini, "OffsetUp", 0.4));
        Options = HarvestSettings.Read(ini);
        string pictures = Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.MyPictures), "GtaDataHarvester");
        Folder = Path.Combine(modFolder, Environment.ExpandEnvironmentVariables(ini.Text("Harvest", "Folder", pictures)));
        Complaints = ini.Complaints.Select(complaint => $"{FileName}: {complaint}").ToArray();
    }

    public Keys SpawnKey { get; }

    public Keys MountKey { get; }

    public Keys RestoreKey { get; }

    public Keys HarvestKey { get; }

    public Keys FrameKey { get; }

    public Keys OverlayKey { get; }

    public string CarModel { get; }

    public string CarPlate { get; }

    public double VerticalFovDegrees { get; }

    /// <summary>From the vehicle's origin, in its frame, metres.</summary>
    public Vector3D CameraOffset { get; }

    public HarvestOptions Options { get; }

    /// <summary>Where sessions go, each into a folder of its own.</summary>
    public string Folder { get; }

    /// <summary>What is wrong with the file, a sentence each.</summary>
    public IReadOnlyList<string> Complaints { get; }

    /// <summary>Reads the file; the defaults hold where there is none.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public static ModSettings Load(string modFolder)
    {
        string path = Path.Combine(modFolder, FileName);
        using TextReader reader = File.Exists(path) ? new StreamReader(path) : TextReader.Null;
        return new ModSettings(IniFile.Read(reader), modFolder);
    }

    /// <summary>The settings without a file.</summary>
    public static ModSettings Default(string modFolder) => new(IniFile.Read(TextReader.Null), modFolder);

    private static Keys Key(IniFile ini, string name, Keys fallback) =>
        ini.Choice("Keys", name, fallback, "a key, such as NumPad0, I or F9");

    private static double Offset(IniFile ini, string name, double fallback) =>
        ini.Number("Camera", name, fallback, -LargestOffsetMetres, LargestOffsetMetres);
}
