using System.Globalization;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Runs.Relabelling;

/// <summary>
/// Reads a calibrated lens from the output of harvester calibrate, or from an ini file with a section [Lens].
/// </summary>
public static class LensFile
{
    private const string Section = $"[{LensSettings.Section}]";

    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="DatasetFormatException">A value is missing or out of range.</exception>
    public static Lens Read(string path)
    {
        string text = InputFile.ReadAllText(path);
        IniFile ini = IniFile.Read(
            new StringReader(text.Contains(Section, System.StringComparison.OrdinalIgnoreCase) ? text : $"{Section}\n{text}")
        );
        Lens lens = LensSettings.Read(ini);
        foreach (KeyValuePair<string, double> value in LensSettings.ValuesOf(lens))
        {
            string found = ini.Text(LensSettings.Section, value.Key, "");
            if (found.Length == 0)
            {
                throw new DatasetFormatException($"{path}: {value.Key} is missing. Use a file with the output of harvester calibrate.");
            }

            if (!double.TryParse(found, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) || number != value.Value)
            {
                throw new DatasetFormatException($"{path}: {value.Key} is '{found}', which is not a valid value for a lens.");
            }
        }

        return lens;
    }
}
