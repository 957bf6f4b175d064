using System.Globalization;
using Harvester.Capture.Windows;

if (args is [ProcessCases.ShowArgument, string seed])
{
    ProcessCases.Show(int.Parse(seed, CultureInfo.InvariantCulture));
    return 0;
}

int passed = 0;
int failed = 0;
string dpi = $"{Native.GetDpiForSystem()} dpi";
CaptureCase[] cases =
[
    .. PlacementCases.All,
    .. RefusalCases.All,
    .. ScalingCases.All,
    .. ProcessCases.All,
    .. DrawingCases.All,
    .. DisplayCases.All,
    .. CostCases.All,
];
foreach (CaptureCase test in cases)
{
    try
    {
        test.Run();
        passed++;
        Console.WriteLine($"ok      {test.Name}");
    }
    catch (InvalidOperationException failure)
    {
        failed++;
        Console.WriteLine($"FAILED  {test.Name}: {failure.Message}");
    }
}

Console.WriteLine(
    string.Create(
        CultureInfo.InvariantCulture,
        $"A grab of 1920x1080 takes {CostCases.MillisecondsPerGrab(1920, 1080):F1} ms, scaled to 800x600 "
            + $"{CostCases.MillisecondsPerGrab(800, 600):F1} ms."
    )
);
Console.WriteLine($"window capture at {dpi}: {passed} passed, {failed} failed");
return failed == 0 ? 0 : 1;
