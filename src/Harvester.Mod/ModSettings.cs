using System;
using System.Collections.Generic;
using System.IO;
using System.Windows.Forms;
using Harvester.Capture.Settings;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>What GtaDataHarvester.ini says.</summary>
internal sealed class ModSettings
{
    private const double LargestOffsetMetres = 20;

    private ModSettings(IniFile ini)
    {
        SpawnKey = Key(ini, "SpawnTestCar", Keys.NumPad0);
        MountKey = Key(ini, "MountCamera", Keys.I);
        RestoreKey = Key(ini, "RestoreCamera", Keys.O);
        CarModel = ini.Text("TestCar", "Model", "adder");
        CarPlate = ini.Text("TestCar", "Plate", "HARVEST");
        VerticalFovDegrees = ini.Number("Camera", "VerticalFov", 50, 1, 130);
        CameraOffset = new Vector3D(Offset(ini, "OffsetRight", 0), Offset(ini, "OffsetForward", 2), Offset(ini, "OffsetUp", 0.4));
        Complaints = ini.Complaints;
    }

    public Keys SpawnKey { get; }

    public Keys MountKey { get; }

    public Keys RestoreKey { get; }

    public string CarModel { get; }

    public string CarPlate { get; }

    public double VerticalFovDegrees { get; }

    /// <summary>From the vehicle's origin, in its frame, metres.</summary>
    public Vector3D CameraOffset { get; }

    /// <summary>What is wrong with the file, a sentence each.</summary>
    public IReadOnlyList<string> Complaints { get; }

    /// <summary>Reads the file; the defaults hold where there is none or it cannot be read.</summary>
    public static ModSettings Load(string path, Messages messages)
    {
        try
        {
            using TextReader reader = File.Exists(path) ? new StreamReader(path) : TextReader.Null;
            return new ModSettings(IniFile.Read(reader));
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            messages.Log($"GtaDataHarvester.ini cannot be read, so the defaults hold: {exception.Message}");
            return new ModSettings(IniFile.Read(TextReader.Null));
        }
    }

    private static Keys Key(IniFile ini, string name, Keys fallback) =>
        ini.Choice("Keys", name, fallback, "a key, such as NumPad0, I or F9");

    private static double Offset(IniFile ini, string name, double fallback) =>
        ini.Number("Camera", name, fallback, -LargestOffsetMetres, LargestOffsetMetres);
}
