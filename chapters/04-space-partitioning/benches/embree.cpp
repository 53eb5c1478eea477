// The driver for Embree 3, beside the benchmark: it answers the same rays about the same triangles.
//
// The benchmark compiles it where Embree 3 is installed (Debian: libembree-dev), gives it two files, and tells it by lines on
// standard input what to do:
//   build   builds the tree with as many threads as there are cores
//   trace   traces all rays in one thread
//   write   the same, and writes the t of each ray to the second file, infinity where nothing is hit
// Each is answered by a line: seconds (of the clock for a build, of the processor for rays), rays that hit, bytes in use.
//
// The first file, little-endian: number of triangles (u32), number of rays (u32), 9 floats for each triangle, 6 for each ray.

#include <embree3/rtcore.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

struct Ray {
    float origin[3], direction[3];
};

static std::atomic<int64_t> bytes_in_use{0};

static bool watch_memory(void*, ssize_t bytes, bool) {
    bytes_in_use += bytes;
    return true;
}

// Time that the processor has spent on this thread: whatever else the machine does is not in it.
static double processor_seconds() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

static RTCScene build(RTCDevice device, const std::vector<float>& corners) {
    RTCScene scene = rtcNewScene(device);
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const size_t triangles = corners.size() / 9;
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles));
    auto* indices = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), triangles));
    for (size_t i = 0; i < corners.size(); i++) vertices[i] = corners[i];
    for (size_t i = 0; i < 3 * triangles; i++) indices[i] = static_cast<uint32_t>(i);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene);
    return scene;
}

int main(int count, char** arguments) {
    if (count != 3) {
        std::fprintf(stderr, "error: expected a file of triangles and rays, and one for the answers\n");
        return 2;
    }
    std::ifstream file(arguments[1], std::ios::binary);
    uint32_t sizes[2] = {0, 0};
    file.read(reinterpret_cast<char*>(sizes), sizeof sizes);
    std::vector<float> corners(9 * size_t(sizes[0]));
    std::vector<Ray> rays(sizes[1]);
    file.read(reinterpret_cast<char*>(corners.data()), std::streamsize(corners.size() * sizeof(float)));
    file.read(reinterpret_cast<char*>(rays.data()), std::streamsize(rays.size() * sizeof(Ray)));
    if (!file) {
        std::fprintf(stderr, "error: the file is shorter than it says\n");
        return 1;
    }

    RTCDevice device = rtcNewDevice(nullptr);
    rtcSetDeviceMemoryMonitorFunction(device, watch_memory, nullptr);
    std::vector<float> answers(rays.size());
    RTCScene scene = nullptr;
    std::string word;
    while (std::cin >> word) {
        const auto start = std::chrono::steady_clock::now();
        const double processor_start = processor_seconds();
        uint64_t hits = 0;
        if (word == "build") {
            if (scene) rtcReleaseScene(scene);
            scene = build(device, corners);
        } else if (scene) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            for (size_t i = 0; i < rays.size(); i++) {
                const Ray& ray = rays[i];
                RTCRayHit query = {};
                query.ray.org_x = ray.origin[0];
                query.ray.org_y = ray.origin[1];
                query.ray.org_z = ray.origin[2];
                query.ray.dir_x = ray.direction[0];
                query.ray.dir_y = ray.direction[1];
                query.ray.dir_z = ray.direction[2];
                query.ray.tfar = std::numeric_limits<float>::infinity();
                query.ray.mask = -1;
                query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                rtcIntersect1(scene, &context, &query);
                hits += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
                answers[i] = query.ray.tfar;
            }
        }
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        const double seconds = word == "build" ? elapsed.count() : processor_seconds() - processor_start;
        if (word == "write") {
            std::ofstream out(arguments[2], std::ios::binary);
            out.write(reinterpret_cast<const char*>(answers.data()), std::streamsize(answers.size() * sizeof(float)));
        }
        std::printf("%.9f %llu %lld\n", seconds, static_cast<unsigned long long>(hits),
                    static_cast<long long>(bytes_in_use.load()));
        std::fflush(stdout);
    }
    if (scene) rtcReleaseScene(scene);
    rtcReleaseDevice(device);
    return 0;
}
